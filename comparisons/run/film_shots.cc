#include "comparisons/run/film_shots.h"

#include <algorithm>
#include <cmath>

namespace tricontact::comparisons {

namespace {

constexpr std::size_t most_shots = 64;  // of a row, before every second one goes

std::vector<float> single(const std::vector<double>& values, float sign = 1) {
    std::vector<float> result(values.size());
    std::ranges::transform(values, result.begin(),
                           [sign](double v) { return sign * static_cast<float>(v); });
    return result;
}

}  // namespace

Shot::Shot(const contact::Surface& s)
    : n_x(s.n_x),
      n_y(s.n_y),
      first(s.first),
      spacing(s.spacing),
      fields{single(s.normal_traction), single(s.tangential_traction_x),
             single(s.tangential_traction_y), single(s.gap), single(s.displacement_z, -1)},
      state(s.contact_state) {}

Shot Shot::on_line_of(const Shot& other) const {
    Shot result = other;
    result.record = record;
    result.label = label;
    result.part = part;
    result.phase = phase;
    result.section = section;
    for (int i = 0; i < other.n_x; ++i) {
        const double at = (other.first[0] + i * other.spacing[0] - first[0]) / spacing[0];
        const bool is_inside = at > -0.5 && at < n_x - 0.5;
        const std::size_t k = is_inside ? static_cast<std::size_t>(std::lround(at)) : 0;
        for (int f = 0; f < n_fields; ++f) result.fields[f][i] = is_inside ? fields[f][k] : 0;
        result.state[i] = is_inside ? state[k] : contact::ContactState::open;
    }
    return result;
}

void ShotRow::add(Shot shot) {
    shot.place = n_seen_ - 1;
    shots_.push_back(std::move(shot));
    while (shots_.size() > most_shots && every_ < n_seen_) {
        every_ *= 2;
        std::erase_if(
            shots_, [this](const Shot& one) { return !one.is_quarter && one.place % every_ != 0; });
    }
}

}  // namespace tricontact::comparisons

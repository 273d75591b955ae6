#include "comparisons/differences/surface_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "comparisons/quantities/resample.h"
#include "contact/base/special_values.h"

namespace tricontact::comparisons {

namespace {

using contact::Surface;
using Field = std::vector<double> Surface::*;

constexpr double phase_apart = 1e-6;  // phases are sums of fractions of a period
constexpr std::array<Field, 4> tractions{&Surface::normal_traction, &Surface::tangential_traction_x,
                                         &Surface::tangential_traction_y, &Surface::friction_bound};
constexpr std::array<Field, 4> movements{&Surface::displacement_x, &Surface::displacement_y,
                                         &Surface::displacement_z, &Surface::gap};

Surface on_grid(Surface surface) {
    if (surface.layout != Surface::Layout::nodes || is_grid(surface)) return surface;
    surface.contact_state.resize(surface.size(), contact::ContactState::open);
    return Resampling(surface)(surface);
}

bool is_line(const Surface& s) {
    return s.layout == Surface::Layout::line;
}

/// A surface at any point: between its points on straight lines.
class Sampler {
  public:
    explicit Sampler(const Surface& surface) : s_(surface) {}

    /// `beyond` outside of the points; an empty field is `beyond` everywhere.
    double at(Field field, double x, double y, double beyond) const {
        const std::vector<double>& values = s_.*field;
        if (values.empty()) return beyond;
        // Springs are those of a body of revolution: by the distance from its axis.
        const double along =
            is_line(s_) ? s_.offset[0] + std::hypot(x - s_.offset[0], y - s_.offset[1]) : x;
        const Place i = place(along, s_.first[0], s_.spacing[0], s_.n_x);
        const Place j = s_.n_y > 1 ? place(y, s_.first[1], s_.spacing[1], s_.n_y) : Place{0, 0};
        if (i.index < 0 || j.index < 0) return beyond;
        const auto row = [&](int k) {
            const std::size_t first = static_cast<std::size_t>(k) * s_.n_x + i.index;
            return i.share == 0 ? values[first]
                                : (1 - i.share) * values[first] + i.share * values[first + 1];
        };
        return j.share == 0 ? row(j.index)
                            : (1 - j.share) * row(j.index) + j.share * row(j.index + 1);
    }

  private:
    struct Place {
        int index = -1;  // negative: beyond
        double share = 0;
    };
    static Place place(double x, double first, double spacing, int n) {
        constexpr double slack = 1e-6;  // of a cell: points that both have are equal to rounding
        double at = (x - first) / spacing;
        if (std::abs(at - std::round(at)) < slack) at = std::round(at);
        if (!(at >= 0 && at <= n - 1)) return {};
        const double whole = std::floor(at);
        return {static_cast<int>(whole), at - whole};
    }

    const Surface& s_;
};

/// The grid of a surface without its fields; of springs one along x, of no more points than are
/// ever looked at.
Surface frame_of(const Surface& s) {
    constexpr int most_springs = 2000;
    Surface frame;
    frame.n_x = s.n_x, frame.n_y = s.n_y;
    frame.first = s.first, frame.spacing = s.spacing;
    frame.offset = s.offset;
    if (is_line(s)) {
        const int stride = (s.n_x + most_springs - 1) / most_springs;
        frame.n_x = (s.n_x - 1) / stride + 1;
        frame.spacing = {s.spacing[0] * stride, s.spacing[0] * stride};
    }
    return frame;
}

Surface sampled(const Surface& s, Surface frame) {
    const Sampler sampler(s);
    const auto fill = [&](Field field, double beyond) {
        if ((s.*field).empty()) return;
        for (int j = 0; j < frame.n_y; ++j)
            for (int i = 0; i < frame.n_x; ++i)
                (frame.*field).push_back(sampler.at(field, frame.x(i), frame.y(j), beyond));
    };
    for (const Field field : tractions) fill(field, 0);
    // The springs' displacements are no field of the plane.
    if (!is_line(s))
        for (const Field field : movements) fill(field, contact::undefined);
    frame.offset = s.offset;
    return frame;
}

using Components = std::vector<Field>;

LargestDifference largest_of(const SurfaceDifference& d, const Components& components) {
    LargestDifference largest;
    double apart2 = 0, b2 = 0;
    for (std::size_t k = 0; k < d.size(); ++k) {
        double apart = 0, of_b = 0, single = 0;
        for (const Field field : components) {
            if ((d.a.*field).empty() || (d.b.*field).empty()) continue;
            single = (d.a.*field)[k] - (d.b.*field)[k];
            apart = std::hypot(apart, single);
            of_b = std::hypot(of_b, (d.b.*field)[k]);
        }
        apart2 += apart * apart, b2 += of_b * of_b;
        largest.over = std::max(largest.over, of_b);
        if (apart <= std::abs(largest.value)) continue;
        largest.value = components.size() == 1 ? single : apart;
        const auto n_x = static_cast<std::size_t>(d.a.n_x);
        largest.place = {d.a.x(static_cast<int>(k % n_x)), d.a.y(static_cast<int>(k / n_x))};
    }
    largest.l2 = b2 > 0 ? std::sqrt(apart2 / b2) : 0;
    return largest;
}

/// The last snapshots of one phase; null without any.
std::pair<const contact::Snapshot*, const contact::Snapshot*> last_common(
    const contact::History& a, const contact::History& b) {
    for (auto of_a = a.snapshots.rbegin(); of_a != a.snapshots.rend(); ++of_a)
        for (auto of_b = b.snapshots.rbegin(); of_b != b.snapshots.rend(); ++of_b)
            if (std::abs(of_a->phase - of_b->phase) < phase_apart) return {&*of_a, &*of_b};
    return {nullptr, nullptr};
}

}  // namespace

std::vector<double> SurfaceDifference::of(std::vector<double> Surface::*field) const {
    if ((a.*field).empty() || (b.*field).empty()) return {};
    std::vector<double> values(size());
    std::ranges::transform(a.*field, b.*field, values.begin(), std::minus<>());
    return values;
}

SurfaceDifference difference_of(const Surface& given_a, const Surface& given_b) {
    const Surface a = on_grid(given_a), b = on_grid(given_b);
    const bool by_a = is_line(a) == is_line(b) ? a.spacing[0] < b.spacing[0] : is_line(b);
    const Surface frame = frame_of(by_a ? a : b);
    SurfaceDifference difference{.a = sampled(a, frame), .b = sampled(b, frame)};
    difference.pressure = largest_of(difference, {&Surface::normal_traction});
    difference.traction =
        largest_of(difference, {&Surface::tangential_traction_x, &Surface::tangential_traction_y});
    return difference;
}

std::vector<SurfaceDifference> model_differences(const std::vector<contact::History>& histories) {
    std::vector<SurfaceDifference> differences;
    for (std::size_t k = 0; k < histories.size(); ++k)
        for (std::size_t i = k + 1; i < histories.size(); ++i) {
            const auto [of_a, of_b] = last_common(histories[i], histories[k]);
            if (!of_a) continue;
            SurfaceDifference& one =
                differences.emplace_back(difference_of(of_a->surface, of_b->surface));
            one.name_a = histories[i].model;
            one.name_b = histories[k].model;
            one.phase = of_a->phase;
        }
    return differences;
}

}  // namespace tricontact::comparisons

#include "mdr/line_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace tricontact::mdr {

namespace {

// Where the load ends beyond its last point, seen from the centre: `inner` is that point's
// neighbour.
double end_of_load(const PointRow& row, std::span<const double> load, double centre, int last,
                   int inner) {
    const double x = std::abs(row.position(last) - centre);
    const double x_inner = std::abs(row.position(inner) - centre);
    if (!(load[inner] > load[last])) return x + row.spacing / 2;
    const double squared =
        x * x + (x * x - x_inner * x_inner) * load[last] / (load[inner] - load[last]);
    return std::min(std::sqrt(squared), x + row.spacing);
}

}  // namespace

LoadSpan load_span(std::span<const double> load) {
    auto carries = [](double q) { return q > 0; };
    const auto first = std::find_if(load.begin(), load.end(), carries);
    if (first == load.end()) return {0, -1};
    return {static_cast<int>(first - load.begin()),
            static_cast<int>(load.rend() - std::find_if(load.rbegin(), load.rend(), carries)) - 1};
}

LoadEnds load_ends(const PointRow& row, std::span<const double> load, double centre) {
    const auto [first, last] = load_span(load);
    if (first >= last) return {row.spacing / 2, row.spacing / 2};
    return {end_of_load(row, load, centre, first, first + 1),
            end_of_load(row, load, centre, last, last - 1)};
}

std::vector<double> abel_weights(std::span<const double> positions, double r) {
    const std::size_t n = positions.size();
    if (n < 2 || positions.front() != 0)
        throw std::domain_error("back_transform: needs two or more positions, the first one 0");
    if (!(r >= 0)) throw std::domain_error("back_transform: the radius must not be negative");
    std::vector<double> weights(n - 1, 0.0);
    if (r >= positions.back()) return weights;

    const double h = positions[1];
    if (r < h) weights[0] = 2 / h * std::sqrt((h - r) * (h + r));
    // ∫ dx/sqrt(x^2 - r^2) = log(x + sqrt(x^2 - r^2))
    auto primitive = [r](double x) { return std::log(x + std::sqrt((x - r) * (x + r))); };
    const auto above = std::upper_bound(positions.begin() + 1, positions.end(), r);
    std::size_t k = std::max<std::size_t>(above - positions.begin() - 1, 1);
    double at_begin = primitive(std::max(positions[k], r));
    for (; k + 1 < n; ++k) {
        const double at_end = primitive(positions[k + 1]);
        weights[k] = at_end - at_begin;
        at_begin = at_end;
    }
    return weights;
}

const std::vector<double>& KeptAbelWeights::at(std::span<const double> positions, double r) {
    constexpr std::size_t most_numbers = 1 << 21;
    const bool same = std::ranges::equal(positions, positions_);
    if (!same || (of_radius_.size() + 1) * positions.size() > most_numbers) of_radius_.clear();
    if (!same) positions_.assign(positions.begin(), positions.end());
    const auto kept = of_radius_.find(r);
    if (kept != of_radius_.end()) return kept->second;
    return of_radius_.emplace(r, abel_weights(positions, r)).first->second;
}

std::vector<double> slopes_of(std::span<const double> positions,
                              std::span<const double> line_load) {
    if (line_load.size() != positions.size())
        throw std::domain_error("slopes_of: one load per position");
    std::vector<double> slopes;
    for (std::size_t k = 0; k + 1 < positions.size(); ++k)
        slopes.push_back((line_load[k + 1] - line_load[k]) / (positions[k + 1] - positions[k]));
    return slopes;
}

double back_transform(std::span<const double> slopes, std::span<const double> weights) {
    if (weights.size() != slopes.size())
        throw std::domain_error("back_transform: one weight per piece");
    return -std::inner_product(weights.begin(), weights.end(), slopes.begin(), 0.) /
           std::numbers::pi;
}

double PointRow::interpolate(std::span<const double> values, double x) const {
    const double index = (x - first) / spacing;
    const double below = std::floor(index), part = index - below;
    auto at = [&](double i) {
        return i >= 0 && i < static_cast<double>(values.size())
                   ? values[static_cast<std::size_t>(i)]
                   : 0.;
    };
    return (1 - part) * at(below) + part * at(below + 1);
}

EvenLoad even_load(const PointRow& row, std::span<const double> load, double centre,
                   int most_pieces) {
    const auto [before, beyond] = load_ends(row, load, centre);
    const double a = (before + beyond) / 2;
    const int stride = static_cast<int>(std::ceil(a / row.spacing / most_pieces));
    EvenLoad even;
    // Whole spacings: what the interpolation misses is then the same everywhere and drops out of
    // differences.
    for (double x = 0; x < a - row.spacing / 10; x += stride * row.spacing) {
        even.positions.push_back(x);
        even.values.push_back(row.even(load, centre, x));
    }
    even.positions.push_back(a);
    even.values.push_back(0);
    return even;
}

double EvenLoad::centre_pressure() const {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < positions.size(); ++k)
        sum += (values[k] - values[k + 1]) / (positions[k] + positions[k + 1]);
    return 2 / std::numbers::pi * sum;
}

EvenLoads even_loads(const PointRow& row, std::span<const double> normal,
                     std::span<const double> tangential, double position) {
    auto [positions, values] = even_load(row, normal, position, most_surface_pieces);
    EvenLoads loads{std::move(positions), std::move(values), {}};
    for (const double x : loads.positions)
        loads.tangential.push_back(row.even(tangential, position, x));
    loads.tangential.back() = 0;
    return loads;
}

contact::Surface make_line_surface(const PointRow& row, int n, double position,
                                   const contact::FrictionLaw& friction, const EvenLoads& loads,
                                   const ShowPoint& show, KeptAbelWeights* kept) {
    const int stride = (n + most_surface_points - 1) / most_surface_points;
    contact::Surface s;
    s.layout = contact::Surface::Layout::line;
    s.n_x = (n - 1) / stride + 1;
    s.n_y = 1;
    s.first = {row.first, 0};
    s.spacing = {stride * row.spacing, 0};
    s.offset = {position, 0};
    for (auto* field :
         {&s.normal_traction, &s.tangential_traction_x, &s.tangential_traction_y, &s.friction_bound,
          &s.displacement_x, &s.displacement_y, &s.displacement_z, &s.gap, &s.slip_x, &s.slip_y,
          &s.dissipation, &s.normal_line_load, &s.tangential_line_load})
        field->assign(s.size(), 0);
    s.contact_state.assign(s.size(), contact::ContactState::open);
    const std::vector<double> normal = slopes_of(loads.positions, loads.normal),
                              tangential = slopes_of(loads.positions, loads.tangential);
    std::vector<double> own;
    for (int k = 0; k < s.n_x; ++k) {
        const double r = std::abs(s.x(k) - position);
        if (r < loads.positions.back()) {
            if (!kept) own = abel_weights(loads.positions, r);
            const std::vector<double>& weights = kept ? kept->at(loads.positions, r) : own;
            s.normal_traction[k] = back_transform(normal, weights);
            s.tangential_traction_x[k] = back_transform(tangential, weights);
        }
        s.friction_bound[k] = friction.bound(s.normal_traction[k]);
        show(k * stride, k, s);
        s.dissipation[k] = std::abs(s.tangential_traction_x[k] * s.slip_x[k]);
    }
    return s;
}

}  // namespace tricontact::mdr

#include "comparisons/quantities/resample.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "contact/base/special_values.h"
#include "statistics/estimate.h"

namespace tricontact::comparisons {

namespace {

using contact::operator+, contact::operator-, contact::operator*;
using contact::Surface;
using contact::Vector2;

constexpr int most_grid_points = 400;  // in each direction: more than a picture shows

/// Corners, then edges, then the centre (VTK's biquadratic quadrilateral).
constexpr std::array<std::array<int, 4>, 4> quarters{
    {{0, 4, 8, 7}, {4, 1, 5, 8}, {8, 5, 2, 6}, {7, 8, 6, 3}}};

using Corners = std::array<Vector2, 4>;

double cross(const Vector2& a, const Vector2& b) {
    return a[0] * b[1] - a[1] * b[0];
}

Corners corners_of(const Surface& s, const std::array<int, 4>& quad) {
    Corners corners;
    for (int k = 0; k < 4; ++k) corners[k] = {s.node_x[quad[k]], s.node_y[quad[k]]};
    return corners;
}

double area(const Corners& c) {
    return std::abs(cross(c[2] - c[0], c[3] - c[1])) / 2;
}

std::array<double, 4> bilinear(double xi, double eta) {
    return {(1 - xi) * (1 - eta), xi * (1 - eta), xi * eta, (1 - xi) * eta};
}

/// Weights of the corners at `p`; empty outside the quadrilateral. Newton's method: the map is
/// bilinear, so that it converges from the centre in any convex quadrilateral.
std::optional<std::array<double, 4>> weights_at(const Corners& c, const Vector2& p) {
    constexpr double margin = 1e-9;  // of a side: no gaps between neighbours
    double xi = 0.5, eta = 0.5;
    for (int iteration = 0; iteration < 20; ++iteration) {
        const auto w = bilinear(xi, eta);
        Vector2 miss = -1 * p;
        for (int k = 0; k < 4; ++k) miss = miss + w[k] * c[k];
        const Vector2 by_xi = (1 - eta) * (c[1] - c[0]) + eta * (c[2] - c[3]);
        const Vector2 by_eta = (1 - xi) * (c[3] - c[0]) + xi * (c[2] - c[1]);
        const double determinant = cross(by_xi, by_eta);
        if (determinant == 0) return {};
        const double d_xi = -cross(miss, by_eta) / determinant;
        const double d_eta = -cross(by_xi, miss) / determinant;
        xi += d_xi;
        eta += d_eta;
        if (std::abs(d_xi) + std::abs(d_eta) < 1e-13) break;
    }
    const bool inside = xi >= -margin && xi <= 1 + margin && eta >= -margin && eta <= 1 + margin;
    return inside ? std::optional(bilinear(std::clamp(xi, 0., 1.), std::clamp(eta, 0., 1.)))
                  : std::nullopt;
}

/// Side of a square as large as a typical quarter of an element [m].
double typical_spacing(const Surface& s) {
    std::vector<double> areas;
    for (const auto& nine : s.quads)
        for (const auto& quarter : quarters)
            areas.push_back(area(corners_of(
                s, {nine[quarter[0]], nine[quarter[1]], nine[quarter[2]], nine[quarter[3]]})));
    return std::sqrt(statistics::median(std::move(areas)));
}

/// Grid lines through 0 that cover [low, high].
struct Lines {
    int n;
    double first;
};
Lines lines_over(double low, double high, double spacing) {
    // A node on a line up to rounding belongs to it.
    const double begin = std::floor(low / spacing + 1e-6), end = std::ceil(high / spacing - 1e-6);
    return {static_cast<int>(end - begin) + 1, begin * spacing};
}

}  // namespace

bool is_grid(const Surface& surface) {
    return surface.layout != Surface::Layout::line && surface.n_x > 0;
}

Resampling::Resampling(const Surface& s) {
    const auto [left, right] = std::ranges::minmax_element(s.node_x);
    const auto [low, high] = std::ranges::minmax_element(s.node_y);
    const double extent = std::max(*right - *left, *high - *low);
    const double spacing = std::max(typical_spacing(s), extent / most_grid_points);
    const Lines x = lines_over(*left, *right, spacing), y = lines_over(*low, *high, spacing);
    frame_.layout = Surface::Layout::grid;
    frame_.n_x = x.n;
    frame_.n_y = y.n;
    frame_.first = {x.first, y.first};
    frame_.spacing = {spacing, spacing};
    sources_.resize(frame_.size());
    for (const auto& nine : s.quads)
        for (const auto& quarter : quarters)
            rasterise(s, {nine[quarter[0]], nine[quarter[1]], nine[quarter[2]], nine[quarter[3]]});
}

void Resampling::rasterise(const Surface& s, const std::array<int, 4>& quad) {
    const Corners corners = corners_of(s, quad);
    const auto range = [&](int d, int n) {
        const auto [low, high] = std::ranges::minmax_element(
            corners, [d](const auto& a, const auto& b) { return a[d] < b[d]; });
        const double slack = 1e-6;  // of a cell
        const auto index = [&](double at) { return (at - frame_.first[d]) / frame_.spacing[d]; };
        return std::pair(std::max(0, static_cast<int>(std::ceil(index((*low)[d]) - slack))),
                         std::min(n - 1, static_cast<int>(std::floor(index((*high)[d]) + slack))));
    };
    const auto [i_begin, i_end] = range(0, frame_.n_x);
    const auto [j_begin, j_end] = range(1, frame_.n_y);
    for (int j = j_begin; j <= j_end; ++j)
        for (int i = i_begin; i <= i_end; ++i) {
            Source& source = sources_[static_cast<std::size_t>(j) * frame_.n_x + i];
            if (source.covered) continue;
            const auto weights = weights_at(corners, {frame_.x(i), frame_.y(j)});
            if (!weights) continue;
            const auto heaviest = std::max_element(weights->begin(), weights->end());
            source = {quad, *weights, quad[heaviest - weights->begin()], true};
        }
}

std::vector<double> Resampling::sampled(const std::vector<double>& values, double outside) const {
    if (values.empty()) return {};
    std::vector<double> result(sources_.size(), outside);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const Source& source = sources_[i];
        if (!source.covered) continue;
        result[i] = 0;
        for (int k = 0; k < 4; ++k) result[i] += source.weights[k] * values[source.nodes[k]];
    }
    return result;
}

Surface Resampling::operator()(const Surface& s) const {
    Surface grid = frame_;
    grid.offset = s.offset;
    for (auto field : {&Surface::normal_traction, &Surface::tension, &Surface::separation_work,
                       &Surface::tangential_traction_x, &Surface::tangential_traction_y,
                       &Surface::friction_bound, &Surface::slip_x, &Surface::slip_y,
                       &Surface::dissipation, &Surface::slip_path, &Surface::friction_work})
        grid.*field = sampled(s.*field, 0);
    for (auto field : {&Surface::displacement_x, &Surface::displacement_y, &Surface::displacement_z,
                       &Surface::gap})
        grid.*field = sampled(s.*field, contact::undefined);
    grid.contact_state.assign(sources_.size(), contact::ContactState::open);
    for (std::size_t i = 0; i < sources_.size(); ++i)
        if (sources_[i].covered) grid.contact_state[i] = s.contact_state[sources_[i].nearest];
    return grid;
}

std::vector<contact::History> on_grids(std::vector<contact::History> histories) {
    for (contact::History& history : histories) {
        std::optional<Resampling> resampling;  // all surfaces of a model have the same nodes
        for (contact::Snapshot& snapshot : history.snapshots) {
            Surface& s = snapshot.surface;
            if (s.layout != Surface::Layout::nodes || is_grid(s)) continue;
            if (!resampling) resampling.emplace(s);
            s = (*resampling)(s);
        }
    }
    return histories;
}

}  // namespace tricontact::comparisons

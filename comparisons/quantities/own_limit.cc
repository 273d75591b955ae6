#include <algorithm>
#include <cmath>
#include <numeric>

#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/resample.h"
#include "comparisons/quantities/surface_fields.h"
#include "contact/friction/radial_bound.h"
#include "contact/models/model_kind.h"
#include "theory/rolling/body_rolling.h"

namespace tricontact::comparisons {

namespace {

using contact::operator*;
using contact::Surface;

/// least = min(least, p moved by `way`) of pressures on a grid, linear between its points; returns
/// the sum.
double lower(const Surface& s, const std::vector<double>& pressure, std::vector<double>& least,
             const contact::Vector2& way) {
    const auto at = [&](int i, int j) {
        if (i < 0 || j < 0 || i >= s.n_x || j >= s.n_y) return 0.;
        return pressure[static_cast<std::size_t>(j) * s.n_x + i];
    };
    const double x = way[0] / s.spacing[0], y = s.n_y > 1 ? way[1] / s.spacing[1] : 0;
    const int i0 = static_cast<int>(std::floor(x)), j0 = static_cast<int>(std::floor(y));
    const double p = x - i0, q = y - j0;
    double sum = 0;
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) {
            double& here = least[static_cast<std::size_t>(j) * s.n_x + i];
            if (here <= 0) continue;
            const int left = i - i0, below = j - j0;
            const double moved = (1 - q) * ((1 - p) * at(left, below) + p * at(left - 1, below)) +
                                 q * ((1 - p) * at(left, below - 1) + p * at(left - 1, below - 1));
            here = std::min(here, moved);
            sum += here;
        }
    return sum;
}

constexpr double steps_per_radius = 64;  // linear between them: an error of f_T,lim of 1e-4

/// Rolling distance at which the least pressures (or bounds) carry `f` of the whole; linear between
/// steps of a quarter of a cell, of fine cells more.
std::optional<double> distance_at(const Surface& surface, const std::vector<double>& pressure,
                                  const contact::Vector2& direction, double f, double radius) {
    std::vector<double> least = pressure;
    for (double& p : least) p = std::max(0., p);
    const double whole = std::accumulate(least.begin(), least.end(), 0.);
    if (!(whole > 0)) return {};
    const double cell =
        surface.n_y > 1 ? std::min(surface.spacing[0], surface.spacing[1]) : surface.spacing[0];
    const double step = std::clamp(radius / steps_per_radius, cell / 4, cell);
    double share = 1;
    // A contact that is longer than the grid along the rolling has no such distance.
    const double longest = surface.n_x * surface.spacing[0] + surface.n_y * surface.spacing[1];
    for (double way = step; way < longest; way += step) {
        lower(surface, pressure, least, way * direction);
        const double now = lower(surface, pressure, least, -way * direction) / whole;
        if (now <= f) return way - step * (f - now) / (share - now);
        share = now;
    }
    return {};
}

}  // namespace

std::vector<double> line_bounds(const Surface& s, double radius) {
    constexpr int pieces = 256;
    const auto radial = contact::RadialBound::of(pieces);
    const double middle = (s.offset[0] - s.first[0]) / s.spacing[0];
    // Up to the edge what the last point inside has: beyond it a strength falls to zero.
    const double last = std::floor(middle + radius / s.spacing[0]) - middle;
    std::vector<double> bound;
    for (int k = 0; k <= pieces; ++k) {
        const double place = middle + std::min(radius * radial->radius(k) / s.spacing[0], last);
        const int i = std::clamp(static_cast<int>(place), 0, std::max(s.n_x - 2, 0));
        const int next = std::min(i + 1, s.n_x - 1);
        bound.push_back(std::lerp(s.friction_bound[i], s.friction_bound[next], place - i));
    }
    const std::vector<double> line = radial->line(bound, radius);
    std::vector<double> at_points;
    for (int i = 0; i < s.n_x; ++i) {
        const double x = (s.x(i) - s.offset[0]) / radius;
        at_points.push_back(
            contact::at_depth_of_chord(line.data(), pieces, std::sqrt(std::max(1 - x * x, 0.))));
    }
    return at_points;
}

std::optional<double> own_amplitude_limit(const contact::Case& c, const contact::History& history) {
    const contact::Snapshot* upright = last_upright(history);
    const double f = tangential_ratio(history);
    if (!c.rolling || !constant_loads(c) || c.period || !upright || !(f > 0 && f < 1)) return {};
    const contact::Vector2 direction{std::cos(c.rolling->angle), std::sin(c.rolling->angle)};
    const Surface& s = upright->surface;
    const double radius = history.scales.contact_radius;
    const bool is_line = s.layout == Surface::Layout::line;
    const bool is_coulomb = c.friction.is_coulomb();
    if (is_line && !is_coulomb && !c.relaxation && theory::has_body_theory(c) &&
        contact::model_kind(history.model).is_independent() && !c.interface.is_elastic())
        return theory::amplitude_limit(c, f);
    Surface grid = is_line || is_grid(s) ? s : Resampling(s)(s);
    // What hardens comes to carry the most that it may.
    if (c.friction.remembers())
        c.friction.law()->bounds({grid.normal_traction}, grid.friction_bound);
    const auto distance =
        distance_at(grid,
                    is_line      ? is_coulomb ? grid.normal_line_load : line_bounds(grid, radius)
                         : is_coulomb ? grid.normal_traction
                                 : grid.friction_bound,
                    is_line ? contact::Vector2{1, 0} : direction, f, radius);
    if (!distance) return {};
    return *distance / radius;
}

}  // namespace tricontact::comparisons

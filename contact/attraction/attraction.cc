#include "contact/attraction/attraction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "contact/base/error.h"
#include "contact/compliances/radial_points.h"

namespace tricontact::contact {

namespace {

/// Of tensions, over sigma_0: an exponential law ends where it has fallen to that.
constexpr double no_tension = 1e-7;

/// A square of the side h under the tension sigma is displaced by 2 x this sigma h/E* in the mean.
constexpr double of_square = .473201;
/// Gaps of cells that touch, but for the solver, over w/sigma_0.
constexpr double touching = 1e-3;

/// The front of a tension crosses the whole circle of a ring at once, and no place of it is ahead
/// of others: it is held by single rings unless it is wider. On 16 to 47 elements per radius forces
/// of pull-off scatter by 2, 1 and .3 % where the tension acts over 4, 6 and 8 rings.
constexpr double spacings_of_a_circle = 8. / 3;

}  // namespace

double point_distance(const ContactPoints& points) {
    if (are_radii(points)) return spacings_of_a_circle * points.spacing[0];
    const double area = std::accumulate(points.area.begin(), points.area.end(), 0.);
    const double n = static_cast<double>(points.size());
    if (points.line_length > 0 && points.n_y == 1) return points.spacing[0];
    // On the edge of a patch of elements points have half an area.
    if (points.n_x > 0 && points.local_ratio > 0) return points.spacing[0];
    return std::sqrt(area / (points.mirrored ? 2 * n : n));
}

// The mean of a step at `distance` over gaps that are spread evenly over `width`: a ramp. It ends
// within the touch at the earliest, so that its integral from there is w.
double Attraction::tension(double gap, double width) const {
    if (!std::isfinite(gap)) return 0;
    gap = std::max(gap, 0.);
    if (decays) {
        const double part = std::exp(-gap / distance);
        return part > no_tension ? strength * part : 0;
    }
    if (is_short_ranged) {
        const double x = std::min(1., gap / distance), left = 1 - x * x;
        return strength * left * left;
    }
    width = std::min(width, 2 * distance);
    if (width <= 0) return gap < distance ? strength : 0;
    return strength * std::clamp((distance - gap) / width + .5, 0., 1.);
}

double Attraction::energy(double gap, double width) const {
    if (!std::isfinite(gap)) return 0;
    gap = std::max(gap, 0.);
    if (is_by_cell) return gap < touching * distance ? -work() : 0;
    if (decays) return -work() * std::exp(-gap / distance);
    width = std::min(width, 2 * distance);
    const double left = distance - gap;
    if (is_short_ranged) {
        const double x = std::min(1., gap / distance), square = x * x;
        return strength * distance * (x * (1 - square * (2. / 3 - square / 5)) - smooth_work);
    }
    if (left >= width / 2) return -strength * left;
    if (left <= -width / 2) return 0;
    return -strength * (left + width / 2) * (left + width / 2) / (2 * width);
}

// A crack whose faces attract each other lets go over the length rho = pi/8 (K/sigma_0)^2, K^2 =
// 2 E* w, if rho is short and the tension sigma_0 (Dugdale 1960; Maugis 1992). Where it falls as
// (1 - (g/distance)^2)^2, rho is pi/2 (K/(I sigma_0))^2 with I = int s t^(-1/2) dt/(sigma_0
// rho^(1/2)) = 1.58 of a gap that opens as t^(3/2). That tension has neither an edge nor a kink:
// over three points loading and unloading pass through the same states.
Attraction attraction_on(const ContactPoints& points, const AttractionLaw& law, double modulus,
                         double wide) {
    const double squared = 2 * modulus * law.work, size = point_distance(points);
    if (law.distance == 0) {
        const double strength = std::sqrt(.63 * squared / (wide * size));
        return {.strength = strength,
                .distance = law.work / (smooth_work * strength),
                .decays = false,
                .is_short_ranged = true};
    }
    const double strength = law.work / law.distance,
                 length = std::numbers::pi / 8 * squared / (strength * strength);
    if (length < least_points_of_range * size)
        throw InputError(fmt::format(
            "adhesion: the tension of {:.4g} Pa acts over {:.3g} m beside the contact, less than "
            "two cells, or distances of nodes (in sections 8/3 of those), of {:.3g} m; make those "
            "finer, or the range longer, or set it to 0",
            strength, length, size));
    return {.strength = strength,
            .distance = law.distance,
            .decays = law.decays,
            .is_short_ranged = false};
}

// A cell that lets go sets free at most what it would as the only one under its tension, of_square
// sigma^2 h^3/E*: that is w h^2 (Griffith's balance).
Attraction attraction_by_cell(const ContactPoints& points, const AttractionLaw& law,
                              double modulus) {
    const double side = points.spacing[0];
    if (law.distance != 0 || points.n_x == 0 || std::abs(points.spacing[1] - side) > 1e-9 * side)
        throw InputError(
            "adhesion: cells let go one by one on grids of squares alone, without a range; let "
            "the edge be a ring");
    const double strength = std::sqrt(modulus * law.work / (of_square * side));
    return {.strength = strength, .distance = law.work / strength, .is_by_cell = true};
}

double GapWidths::at(std::span<const double> gap, int i, int j) const {
    const int n_x = points_.n_x, n_y = points_.n_y;
    const double here = gap[static_cast<std::size_t>(j) * n_x + i];
    const auto of = [&](int k, int l) {
        if (points_.periodic) {
            k = (k + n_x) % n_x;
            l = (l + n_y) % n_y;
        }
        if (points_.mirrored && l < 0) l = -l;
        const bool is_there = k >= 0 && k < n_x && l >= 0 && l < n_y;
        const double value = is_there ? gap[static_cast<std::size_t>(l) * n_x + k] : here;
        return std::isfinite(value) ? value : here;
    };
    const double along_x = std::abs(of(i + 1, j) - of(i - 1, j)) / 2;
    return along_x + (n_y > 1 ? std::abs(of(i, j + 1) - of(i, j - 1)) / 2 : 0);
}

void GapWidths::of(std::span<const double> gap, std::span<double> width) const {
    for (int j = 0; j < points_.n_y; ++j)
        for (int i = 0; i < points_.n_x; ++i)
            width[static_cast<std::size_t>(j) * points_.n_x + i] = at(gap, i, j);
}

}  // namespace tricontact::contact

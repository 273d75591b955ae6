#include "theory/worn_paraboloid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tricontact::theory {

using std::numbers::pi;

WornParaboloid WornParaboloid::of_cycle(double radius, double depth, double shift_amplitude,
                                        double ratio) {
    return {radius, depth, std::sqrt(radius * std::max(0., depth - shift_amplitude / ratio))};
}

double WornParaboloid::profile(double r) const {
    const double unworn = r * r / (2 * radius), c = stick_radius;
    if (r <= c) return unworn;
    const double angle = std::asin(c / r);
    const double limit =
        2 / (pi * radius) * (r * r / 2 * angle - c / 2 * std::sqrt((r - c) * (r + c))) +
        depth * (1 - 2 / pi * angle);
    return std::max(unworn, limit);
}

double WornParaboloid::worn(double r) const {
    return profile(r) - r * r / (2 * radius);
}

}  // namespace tricontact::theory

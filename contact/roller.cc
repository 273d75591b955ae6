#include "contact/roller.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/error.h"

namespace tricontact::contact {

Roller::Roller(double radius, double length, double chamfer)
    : radius_(radius), half_length_(length / 2), chamfer_(chamfer) {
    if (!(radius > 0) || !std::isfinite(radius) || !(length > 0) || !std::isfinite(length))
        throw InputError("roller: radius and length must be positive and finite");
    if (!(chamfer >= 0 && chamfer <= half_length_))
        throw InputError("roller: the chamfer must lie between 0 and half the length");
}

double Roller::rounded_distance(double y) const {
    return std::max(0., std::abs(y) - (half_length_ - chamfer_));
}

// r - sqrt(r^2 - s^2) = s^2 / (r + sqrt(r^2 - s^2)): no cancellation at small s.
double Roller::height(double x, double y) const {
    if (std::abs(y) > half_length_) return std::numeric_limits<double>::infinity();
    const double straight = x * x / (2 * radius_), s = rounded_distance(y);
    if (s == 0) return straight;
    // Rounding may put s past the radius.
    return straight + s * s / (chamfer_ + std::sqrt(std::max(0., chamfer_ * chamfer_ - s * s)));
}

Vector2 Roller::slope(double x, double y) const {
    const double s = rounded_distance(y);
    const double steep = s > 0 ? s / std::sqrt(std::max(0., chamfer_ * chamfer_ - s * s)) : 0;
    return {x / radius_, std::copysign(steep, y)};
}

}  // namespace tricontact::contact

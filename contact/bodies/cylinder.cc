#include "contact/bodies/cylinder.h"

#include <algorithm>
#include <cmath>

#include "contact/error.h"
#include "contact/special_values.h"

namespace tricontact::contact {

Cylinder::Cylinder(double radius, double length) : radius_(radius), length_(length) {
    if (!(radius > 0) || !std::isfinite(radius))
        throw InputError("indenter: the radius must be positive and finite");
    if (!(length > 0) || !std::isfinite(length))
        throw InputError("indenter: the length must be positive and finite");
}

double Cylinder::height(double x, double y) const {
    return std::abs(y) <= length_ / 2 ? x * x / (2 * radius_) : infinity;
}

Vector2 Cylinder::slope(double x, double) const {
    return {x / radius_, 0};
}

Roller::Roller(double radius, double length, double chamfer)
    : cylinder_(radius, length), chamfer_(chamfer) {
    if (!(chamfer >= 0 && chamfer <= length / 2))
        throw InputError("indenter: the chamfer must lie between 0 and half the length");
}

double Roller::rounded_distance(double y) const {
    return std::clamp(std::abs(y) - (cylinder_.length() / 2 - chamfer_), 0., chamfer_);
}

// r - sqrt(r^2 - s^2) = s^2 / (r + sqrt(r^2 - s^2)): no cancellation at small s.
double Roller::height(double x, double y) const {
    const double s = rounded_distance(y), r = chamfer_;
    return cylinder_.height(x, y) + (s > 0 ? s * s / (r + std::sqrt(r * r - s * s)) : 0);
}

Vector2 Roller::slope(double x, double y) const {
    constexpr double steepest = 1e6;
    const double s = rounded_distance(y), rest = std::sqrt(chamfer_ * chamfer_ - s * s);
    const double steep = s > 0 ? s / std::max(rest, s / steepest) : 0;
    return {cylinder_.slope(x, y)[0], std::copysign(steep, y)};
}

}  // namespace tricontact::contact

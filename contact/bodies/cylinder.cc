#include "contact/bodies/cylinder.h"

#include <cmath>
#include <limits>

#include "contact/error.h"

namespace tricontact::contact {

Cylinder::Cylinder(double radius, double length) : radius_(radius), length_(length) {
    if (!(radius > 0) || !std::isfinite(radius))
        throw InputError("indenter: the radius must be positive and finite");
    if (!(length > 0) || !std::isfinite(length))
        throw InputError("indenter: the length must be positive and finite");
}

double Cylinder::height(double x, double y) const {
    return std::abs(y) <= length_ / 2 ? x * x / (2 * radius_)
                                      : std::numeric_limits<double>::infinity();
}

Vector2 Cylinder::slope(double x, double) const {
    return {x / radius_, 0};
}

}  // namespace tricontact::contact

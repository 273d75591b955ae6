#include "contact/bodies/indenter.h"

#include <cmath>
#include <limits>

#include "contact/bodies/profile_transform.h"
#include "contact/error.h"
#include "contact/special_values.h"

namespace tricontact::contact {

namespace {

double checked_radius(double radius) {
    if (!(radius > 0) || !std::isfinite(radius))
        throw InputError("indenter: the radius must be positive and finite");
    return radius;
}
}  // namespace

double AxisymmetricIndenter::height(double x, double y) const {
    const double r = std::hypot(x, y);
    return r <= outer_radius() ? profile(r) : infinity;
}

Vector2 AxisymmetricIndenter::slope(double x, double y) const {
    const double r = std::hypot(x, y);
    if (r == 0) return {0, 0};
    const double slope = profile_slope(r);
    return {slope * x / r, slope * y / r};
}

double AxisymmetricIndenter::slope_moment(double x, int k) const {
    return transformed_slope_moment(*this, x, k);
}

double AxisymmetricIndenter::centre_pressure(double x) const {
    return transformed_centre_pressure(*this, x);
}

Paraboloid::Paraboloid(double radius) : radius_(checked_radius(radius)) {}
double Paraboloid::outer_radius() const {
    return infinity;
}

double Paraboloid::slope_moment(double x, int k) const {
    return (k == 0 ? x : 2. / 3 * x * x * x) / radius_;
}

Sphere::Sphere(double radius) : radius_(checked_radius(radius)) {}

// R - sqrt(R^2 - r^2) = r^2 / (R + sqrt(R^2 - r^2)): no cancellation at small r.
double Sphere::profile(double r) const {
    return r * r / (radius_ + std::sqrt(radius_ * radius_ - r * r));
}

double Sphere::profile_slope(double r) const {
    return r / std::sqrt(radius_ * radius_ - r * r);
}

}  // namespace tricontact::contact

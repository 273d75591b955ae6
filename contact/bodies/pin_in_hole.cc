#include "contact/bodies/pin_in_hole.h"

#include <cmath>
#include <numbers>

#include "contact/base/error.h"

namespace tricontact::contact {

namespace {

constexpr double widest_angle = 89 * std::numbers::pi / 180;

}  // namespace

PinInHole::PinInHole(double radius, double hole_radius)
    : radius_(radius), hole_radius_(hole_radius) {
    if (!is_positive_and_finite(radius) || !(hole_radius > radius) || !std::isfinite(hole_radius))
        throw InputError("indenter: a pin needs a radius above 0 that is below that of its hole");
}

// The pin's centre lies D = R_hole - R below that of the hole. A ray from it at the angle theta
// meets the hole at the distance sqrt(R_hole^2 - D^2 sin^2) - D cos. In terms without cancellation:
//   gap = D (1 - cos) - D^2 sin^2 / (R_hole + sqrt(...)).
double PinInHole::height(double x, double /*y*/) const {
    const double angle = x / radius_;
    if (std::abs(angle) >= widest_angle) return infinity;
    const double clearance = hole_radius_ - radius_, sine = clearance * std::sin(angle);
    const double half = std::sin(angle / 2);
    const double root = std::sqrt(hole_radius_ * hole_radius_ - sine * sine);
    return (2 * clearance * half * half - sine * sine / (hole_radius_ + root)) / std::cos(angle);
}

Vector2 PinInHole::slope(double x, double y) const {
    const double angle = x / radius_, cosine = std::cos(angle);
    const double clearance = hole_radius_ - radius_, sine = clearance * std::sin(angle);
    const double root = std::sqrt(hole_radius_ * hole_radius_ - sine * sine);
    const double of_gap = sine - sine * clearance * cosine / root;
    return {(of_gap / cosine + height(x, y) * std::tan(angle)) / radius_, 0};
}

}  // namespace tricontact::contact

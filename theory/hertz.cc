#include "theory/hertz.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::theory {

namespace {
double relative_radius(const contact::HalfSpaceScales& scales, double r) {
    if (!(r >= 0)) throw std::domain_error("hertz: the radius r must not be negative");
    return r / scales.contact_radius;
}
}  // namespace

double hertz_pressure(const contact::HalfSpaceScales& scales, double r) {
    const double rho = relative_radius(scales, r);
    return rho < 1 ? scales.peak_pressure * std::sqrt((1 - rho) * (1 + rho)) : 0;
}

double hertz_surface_displacement(const contact::HalfSpaceScales& scales, double r) {
    const double rho = relative_radius(scales, r);
    if (rho <= 1) return scales.indentation * (1 - rho * rho / 2);
    const double root = std::sqrt((rho - 1) * (rho + 1));
    // Far away the two terms of eq. 3.42a cancel, leaving Boussinesq's 4 / (3 pi rho): series in
    // 1/rho^2; at the switch truncation (1e-14) and cancellation (1e-12) are both negligible.
    if (rho > 100) {
        const double square = 1 / (rho * rho);
        const double series = 4. / 3 + square * (2. / 15 + square * 3. / 70);
        return scales.indentation * series / (std::numbers::pi * rho);
    }
    return scales.indentation * ((2 - rho * rho) * std::asin(1 / rho) + root) / std::numbers::pi;
}

double hertz_modulus_from_indentation(double force, double radius, double indentation) {
    return 3. / 4 * force / (std::sqrt(radius) * std::pow(indentation, 1.5));
}

double hertz_modulus_from_contact_radius(double force, double radius, double contact_radius) {
    return 3. / 4 * force * radius / std::pow(contact_radius, 3);
}

}  // namespace tricontact::theory

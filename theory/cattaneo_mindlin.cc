#include "theory/cattaneo_mindlin.h"

#include <cmath>
#include <stdexcept>

#include "theory/arguments.h"

namespace tricontact::theory {

namespace {

void check_ratio(double f) {
    check_unit_interval("Cattaneo-Mindlin", "F_T/(mu F_N)", f);
}

// sqrt(c^2 - rho^2), zero outside of c.
double ellipse(double c, double rho) {
    return rho < c ? std::sqrt((c - rho) * (c + rho)) : 0;
}

// 1 - (1 - f)^(1/3) without cancellation at small f.
double slip_annulus(double f) {
    return f < 1 ? -std::expm1(std::log1p(-f) / 3) : 1;
}

// The braces of W0, of order f^3 while its terms are of order 1. With t = (1 - f)^(1/3) they are
// (1 - 5 t^2 + 5 t^3 - t^5)/6 = (1 - t)^3 (1 + 3 t + t^2)/6: no cancellation.
double dissipation_function(double f) {
    const double annulus = slip_annulus(f), t = 1 - annulus;
    return annulus * annulus * annulus * (1 + t * (3 + t)) / 6;
}

}  // namespace

double stick_radius_ratio(double f) {
    check_ratio(f);
    return std::cbrt(1 - f);
}

double cattaneo_mindlin_traction(double rho, double f) {
    if (!(rho >= 0)) throw std::domain_error("Cattaneo-Mindlin: r/a must not be negative");
    return ellipse(1, rho) - ellipse(stick_radius_ratio(f), rho);
}

double static_shift_ratio(double f) {
    check_ratio(f);
    const double annulus = slip_annulus(f);
    return annulus * (2 - annulus);
}

double cycle_dissipation(const OscillatingForce& load) {
    check_ratio(load.tangential_ratio);
    const bool positive = load.friction_coefficient > 0 && load.normal_force > 0 &&
                          load.effective_shear_modulus > 0 && load.contact_radius > 0;
    if (!positive) throw std::domain_error("cycle_dissipation: mu, F_N, G*, a must be positive");
    const double limit = load.friction_coefficient * load.normal_force;
    return 18. / 5 * limit * limit / (load.effective_shear_modulus * load.contact_radius) *
           dissipation_function(load.tangential_ratio);
}

}  // namespace tricontact::theory

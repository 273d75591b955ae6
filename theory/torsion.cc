#include "theory/torsion.h"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "theory/arguments.h"

namespace tricontact::theory {

namespace {

/// K(k) - E(k), k^2 = 1 - c^2: the twist of the punches from c on, over its unit.
double elliptic(double c) {
    const double k = std::sqrt((1 - c) * (1 + c));
    return std::comp_ellint_1(k) - std::comp_ellint_2(k);
}

}  // namespace

double twist_ratio(double stick_radius_ratio) {
    check_unit_interval("Lubkin", "c/a", stick_radius_ratio);
    if (stick_radius_ratio == 0) throw std::domain_error("Lubkin: without stick there is no twist");
    return 3 / (4 * std::numbers::pi) * elliptic(stick_radius_ratio);
}

double torque_ratio(double stick_radius_ratio) {
    const double c = stick_radius_ratio;
    check_unit_interval("Lubkin", "c/a", c);
    if (c == 1) return 0;
    constexpr double least = 1e-8;  // below, k rounds to 1; s^2 K(k) is negligible
    // By parts: int_c^1 s^3 dphi = c^3 phi(c) + 3 int_c^1 s^2 phi(s) ds.
    boost::math::quadrature::tanh_sinh<double> rule;
    const double rest =
        rule.integrate([](double s) { return s > least ? 3 * s * s * elliptic(s) : 0; }, c, 1.);
    const double inner = c > 0 ? c * c * c * elliptic(c) : 0;
    return 4 / std::numbers::pi * (inner + rest);
}

}  // namespace tricontact::theory

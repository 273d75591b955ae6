#include "theory/rolling/oscillating_rolling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "contact/base/root.h"
#include "theory/arguments.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::theory {

namespace {

void check_mapping(double kappa) {
    if (!(kappa > 0 && kappa <= mdr_mapping))
        throw std::domain_error("oscillating rolling: kappa must lie in (0, 3/2]");
}

double thesis_increment(double w, double f, double kappa, double factor) {
    const double excess = w - amplitude_limit(f, kappa);
    check_unit_interval("oscillating rolling", "w = W/a", w);
    return excess > 0 ? std::sqrt(factor * static_shift_ratio(f)) * excess : 0;
}

}  // namespace

// Without cancellation at small u.
double static_force_ratio(double u) {
    return u < 1 ? -std::expm1(1.5 * std::log1p(-u)) : 1;
}

std::optional<double> settled_shift_ratio(double w, double f, double kappa) {
    check_unit_interval("oscillating rolling", "w = W/a", w);
    check_unit_interval("oscillating rolling", "f = F_T/(mu F_N)", f);
    check_mapping(kappa);
    if (f > shakedown_limit(w, kappa)) return std::nullopt;
    const auto residual = [=](double u) { return static_force_ratio(u) - kappa * w * u - f; };
    const double highest = (1 - w) * (1 + w);
    // At the limit itself rounding may leave no change of sign: the root is then the end point.
    if (residual(highest) <= 0) return highest;
    return contact::bracketed_root(residual, 0, highest);
}

double mapping_parameter(double w, double f, double u) {
    check_unit_interval("oscillating rolling", "w = W/a", w);
    check_unit_interval("oscillating rolling", "f = F_T/(mu F_N)", f);
    check_unit_interval("oscillating rolling", "u = U/U_max", u);
    if (w == 0 || u == 0) throw std::domain_error("mapping_parameter: w and u must not vanish");
    return (static_force_ratio(u) - f) / (w * u);
}

double shakedown_limit(double w, double kappa) {
    check_unit_interval("oscillating rolling", "w = W/a", w);
    check_mapping(kappa);
    // 1 - kappa w (1 - w^2) - w^3, its factor (1 - w) taken out: zero and positive where it should.
    return (1 - w) * (1 + w + w * w - kappa * w * (1 + w));
}

double amplitude_limit(double f, double kappa) {
    check_unit_interval("oscillating rolling", "f = F_T/(mu F_N)", f);
    check_mapping(kappa);
    // Monotone for kappa <= 3/2: the derivative, linear in w^2, is negative at 0 and not positive
    // at 1.
    return contact::bracketed_root([=](double w) { return shakedown_limit(w, kappa) - f; }, 0., 1.);
}

double mdr_threshold_slope(double f) {
    const double w = amplitude_limit(f);
    return 4 * (1 - w) * (1 + w) / (1 + w - w * w + w * w * w / 3);
}

double thesis_increment_parallel(double w, double f) {
    return thesis_increment(w, f, thesis_mapping_parallel, 2);
}

double thesis_increment_perpendicular(double w, double f) {
    return thesis_increment(w, f, thesis_mapping_perpendicular, 5);
}

ShakedownZones shakedown_zones(double w, double u) {
    check_unit_interval("oscillating rolling", "w = W/a", w);
    check_unit_interval("oscillating rolling", "u = U/U_max", u);
    const double stick = std::sqrt(1 - u) - w;
    // u = 1 - w^2 is the limit itself: a rounding error below zero is no error of the caller.
    if (stick < -8 * std::numeric_limits<double>::epsilon())
        throw std::domain_error("shakedown_zones: u must not exceed 1 - w^2");
    return {std::max(stick, 0.), 1 - w};
}

double mdr_shakedown_traction(double rho, double w, double u) {
    if (!(rho >= 0)) throw std::domain_error("mdr_shakedown_traction: r/a must not be negative");
    const auto [stick, slip] = shakedown_zones(w, u);
    if (rho >= slip) return 0;
    const double root = std::sqrt((slip - rho) * (slip + rho));
    if (rho >= stick) return root + w * std::acosh(slip / rho);
    const double inner = std::sqrt((stick - rho) * (stick + rho));
    // acosh(b/rho) - acosh(c/rho), regular at rho = 0
    return root - inner + w * std::log((slip + root) / (stick + inner));
}

}  // namespace tricontact::theory

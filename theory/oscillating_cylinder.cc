#include "theory/oscillating_cylinder.h"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contact/base/root.h"
#include "theory/arguments.h"
#include "theory/creep_law.h"

namespace tricontact::theory {

namespace {

using std::numbers::pi;

void check_between(const char* name, double value, double low, double high) {
    if (!(value >= low && value <= high))
        throw std::domain_error("oscillating cylinder: " + std::string(name) + " is out of range");
}

void check_zones(double w, double c) {
    check_between("w = W/a", w, 0, 1);
    // c = 1 - w of another rounding is no error of the caller.
    check_between("c = c_sd/a", c, 0, 1 - w + 8 * std::numeric_limits<double>::epsilon());
}

/// Least pressure of a period over p0.
double least_pressure(double s, double w) {
    return std::sqrt(std::max(0., (1 - s - w) * (1 + s + w)));
}

/// (4/pi) ∫_0^V t(s) factor(s, v) dv; t ends like a root, s is not smooth at v = 0 for small c.
template <typename Factor>
double over_slip_zone(double w, double c, const Factor& factor) {
    const double b = 1 - w;
    if (c >= b) return 0;
    boost::math::quadrature::tanh_sinh<double> rule;
    const auto integrand = [&](double v) {
        const double s = std::hypot(c, v);
        return least_pressure(s, w) * factor(s, v);
    };
    return 4 / pi * rule.integrate(integrand, 0., std::sqrt((b - c) * (b + c)));
}

void check_thesis_zones(double w, double c) {
    check_unit_interval("thesis' cylinder", "w = W/a", w);
    if (!(c >= 0 && c < 1 - w))
        throw std::domain_error("thesis' cylinder: c = c_sd/a must lie in [0, 1 - w)");
}

double semi_ellipse(double x, double half_width) {
    return std::sqrt(std::max(0., (half_width - x) * (half_width + x))) / half_width;
}

}  // namespace

double line_stick_force(double w, double c) {
    check_zones(w, c);
    return over_slip_zone(w, c, [](double, double) { return 1.; });
}

std::optional<double> line_stick_half_width(double w, double f) {
    check_between("f = F_T/(mu F_N)", f, 0, 1);
    if (f > line_shakedown_limit(w)) return std::nullopt;
    // At the limit itself rounding may leave no change of sign.
    if (line_stick_force(w, 0) <= f) return 0.;
    return contact::bracketed_root([&](double c) { return line_stick_force(w, c) - f; }, 0., 1 - w);
}

double line_shakedown_traction(double x, double w, double c) {
    check_zones(w, c);
    const double distance = std::abs(x);
    if (distance >= 1 - w) return 0;
    if (distance >= c) return least_pressure(distance, w);
    const double e = std::sqrt((c - distance) * (c + distance));
    const double v_end = std::sqrt(std::max(0., (1 - w - c) * (1 - w + c)));
    // v = e tan(angle)
    boost::math::quadrature::tanh_sinh<double> rule;
    const auto integrand = [&](double angle) {
        return least_pressure(std::hypot(c, e * std::tan(angle)), w);
    };
    return v_end > 0 ? 2 / pi * rule.integrate(integrand, 0., std::atan(v_end / e)) : 0;
}

double line_static_shift_ratio(double f, double lambda) {
    check_between("f = F_T/(mu F_N)", f, 0, 1);
    check_between("lambda", lambda, 1, std::numeric_limits<double>::max());
    return f < 1 ? 1 - (1 - f) * (1 - std::log1p(-f) / (2 * lambda)) : 1;
}

double line_cycle_dissipation(double f) {
    check_between("f = F_T/(mu F_N)", f, 0, 1);
    // f^3/3 + f^4/6 + ... where the terms cancel.
    if (f < 1e-3) return f * f * f * (1. / 3 + f * (1. / 6 + f / 10));
    return f < 1 ? f * (2 - f) + 2 * (1 - f) * std::log1p(-f) : 1;
}

// A flat punch of the half width r under F/L shifts by 2 F/(pi E* L) (lambda - 1/2 - ln r).
double line_settled_shift_ratio(double w, double c, double lambda) {
    check_between("lambda", lambda, 1, std::numeric_limits<double>::max());
    const double log_c = c > 0 ? std::log(c) : 0;  // its factor vanishes with c
    const double logarithm = over_slip_zone(w, c, [&](double s, double v) {
        return std::log(s + v) * v / s + log_c * (c / s) * (c / (s + v));
    });
    return (line_stick_force(w, c) * (lambda - .5) - logarithm) / lambda;
}

double line_shakedown_displacement(double x, double w, double c, double lambda) {
    check_between("c = c_sd/a", c, std::numeric_limits<double>::min(), 1);
    const double settled = line_settled_shift_ratio(w, c, lambda), distance = std::abs(x);
    if (distance <= c) return settled;
    const double force = line_stick_force(w, c), b = 1 - w;
    const auto lost = [&](double eta) {
        const double r = std::max(c, distance / std::cosh(eta));
        return force - (r < b ? line_stick_force(w, r) : 0);
    };
    // Punches end at b: beyond it all of the load counts.
    const double whole = distance > b ? std::acosh(distance / b) : 0,
                 end = std::acosh(distance / c);
    boost::math::quadrature::tanh_sinh<double> rule;
    const double rest = c < b ? rule.integrate(lost, whole, end) : 0;
    return settled - (whole * force + rest) / lambda;
}

double line_shakedown_limit(double w) {
    check_between("w = W/a", w, 0, 1);
    return 2 / pi * (std::acos(w) - w * std::sqrt((1 - w) * (1 + w)));
}

double line_amplitude_limit(double f) {
    check_between("f = F_T/(mu F_N)", f, 0, 1);
    if (line_shakedown_limit(0) <= f) return 0;
    return contact::bracketed_root([&](double w) { return line_shakedown_limit(w) - f; }, 0., 1.);
}

double line_steady_slope(double f, double lambda) {
    check_between("lambda", lambda, 1, std::numeric_limits<double>::max());
    return 8 * carter_creepage_ratio(f) / lambda;
}

double thesis_line_traction(double x, double w, double c) {
    check_thesis_zones(w, c);
    const double distance = std::abs(x), b = 1 - w;
    if (distance >= b) return 0;
    if (distance >= c) return semi_ellipse(distance + w, 1);
    const double t21 = semi_ellipse(c + w, 1) / semi_ellipse(c, b);
    return t21 * semi_ellipse(distance, b) - t21 * c / b * semi_ellipse(distance, c);
}

double thesis_line_stick_force(double w, double c) {
    check_thesis_zones(w, c);
    const double sum = c + w, b = 1 - w, k = c / b;
    const double stick = b * (std::asin(k) - k * k * pi / 2) / std::sqrt((1 - k) * (1 + k));
    return 2 / pi * (std::acos(sum) + semi_ellipse(sum, 1) * (stick - w));
}

std::optional<double> thesis_line_stick_half_width(double w, double f) {
    check_unit_interval("thesis' cylinder", "f = F_T/(mu F_N)", f);
    if (f > line_shakedown_limit(w)) return std::nullopt;
    if (thesis_line_stick_force(w, 0) <= f) return 0.;
    const auto excess = [&](double c) {
        return c < 1 - w ? thesis_line_stick_force(w, c) - f : -f;
    };
    return contact::bracketed_root(excess, 0., 1 - w);
}

double thesis_line_static_shift_ratio(double f) {
    check_unit_interval("thesis' cylinder", "f = F_T/(mu F_N)", f);
    return 1 - std::pow(1 - f, 0.92);
}

std::optional<double> thesis_line_settled_shift_ratio(double w, double f) {
    if (f > line_shakedown_limit(w)) return std::nullopt;
    return thesis_line_static_shift_ratio(f) + 0.3 * f * w;
}

double thesis_line_amplitude_limit(double f) {
    check_unit_interval("thesis' cylinder", "f = F_T/(mu F_N)", f);
    return 1 - std::pow(f, 0.73);
}

double thesis_line_limit_shift_ratio(double f) {
    check_unit_interval("thesis' cylinder", "f = F_T/(mu F_N)", f);
    return std::pow(f, 0.87);
}

double thesis_line_increment(double w, double f) {
    check_unit_interval("thesis' cylinder", "w = W/a", w);
    return 0.64 * f * std::max(0., w - thesis_line_amplitude_limit(f));
}

}  // namespace tricontact::theory

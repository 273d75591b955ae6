#include "theory/body_pressure.h"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "contact/bodies/rounded_punch.h"

namespace tricontact::theory {

namespace {

template <typename Function>
double integral(Function f, double low, double high) {
    thread_local boost::math::quadrature::tanh_sinh<double> quadrature;  // keeps its abscissas
    return low < high ? quadrature.integrate(f, low, high, 1e-10) : 0;
}

/// Whether there is a pressure at rho.
bool inside(double rho) {
    if (!(rho >= 0)) throw std::domain_error("pressure: r/a must not be negative");
    return rho < 1;
}

}  // namespace

double power_law_pressure(double exponent, double rho) {
    if (!(exponent >= 1) || !std::isfinite(exponent))
        throw std::domain_error("power_law_pressure: the exponent must be at least 1");
    if (!inside(rho)) return 0;
    if (rho == 0)
        return exponent > 1 ? (exponent + 1) / (2 * (exponent - 1))
                            : std::numeric_limits<double>::infinity();
    if (exponent == 1) return std::acosh(1 / rho);
    const double end = std::sqrt((1 - rho) * (1 + rho));
    auto growth = [=](double s) { return std::pow(rho * rho + s * s, exponent / 2 - 1); };
    return (exponent + 1) / 2 * integral(growth, 0, end);
}

double rounded_punch_pressure(double flat_ratio, double rho) {
    if (!(flat_ratio > 0 && flat_ratio < 1))
        throw std::domain_error("rounded_punch_pressure: b/a must lie in (0, 1)");
    if (!inside(rho)) return 0;
    const double b = flat_ratio, end = std::sqrt((1 - rho) * (1 + rho));
    auto growth = [=](double s) {
        const double x = std::hypot(rho, s), beyond = std::sqrt(std::max(0., (x - b) * (x + b)));
        return (2 * beyond - b * std::atan2(beyond, b)) / x;
    };
    const double begin = std::sqrt(std::max(0., (b - rho) * (b + rho)));
    return integral(growth, begin, end) / contact::RoundedPunch(b, 1).pressed_area(1);
}

}  // namespace tricontact::theory

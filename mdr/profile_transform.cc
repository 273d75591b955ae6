#include "mdr/profile_transform.h"

#include <fmt/format.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/error.h"

namespace tricontact::mdr {

double power_law_factor(double n) {
    if (!(n >= 1) || !std::isfinite(n))
        throw std::domain_error("power_law_factor: the exponent must be at least 1");
    // Gamma overflows beyond 171: logarithms
    const double ratio = std::exp(std::lgamma(n / 2) - std::lgamma((n + 1) / 2));
    return n * std::sqrt(std::numbers::pi) / 2 * ratio;
}

double transformed_mean_slope(const contact::AxisymmetricIndenter& indenter, double x) {
    const double radius = std::abs(x);
    if (!(radius <= indenter.outer_radius()))
        throw std::domain_error("transformed_profile: x lies outside of the indenter");
    auto slope = [&](double t) { return indenter.profile_slope(radius * std::sin(t)); };
    // Every bisection halves what a kink costs: 40 of them leave 1e-12 of the interval.
    constexpr unsigned max_bisections = 40;
    double error = 0, absolute = 0;
    const double result = boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
        slope, 0., std::numbers::pi / 2, max_bisections, 1e-13, &error, &absolute);
    if (!(error <= 1e-10 * absolute))
        throw contact::NotConverged(fmt::format(
            "transform of the indenter's profile at x = {:.6g} m: relative error {:.3g} after {} "
            "bisections; the slope of the profile is too rough",
            x, error / absolute, max_bisections));
    return result;
}

double transformed_profile(const contact::AxisymmetricIndenter& indenter, double x) {
    return x == 0 ? 0 : std::abs(x) * transformed_mean_slope(indenter, x);
}

}  // namespace tricontact::mdr

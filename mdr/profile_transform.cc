#include "mdr/profile_transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
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
    // Double exponential quadrature: indifferent to singularities at the ends of a piece.
    thread_local boost::math::quadrature::tanh_sinh<double> quadrature;  // keeps its abscissas
    double value = 0, error = 0, begin = 0;
    auto add_piece = [&](double end) {
        // Strictly inside of the piece: rounding must not read the slope beyond a kink or the rim.
        const double least = std::nextafter(begin, end), most = std::nextafter(end, begin);
        const double start = std::asin(begin / radius);
        const double length = std::asin(end / radius) - start;
        auto slope = [&](double part) {
            const double r = radius * std::sin(start + part * length);
            return indenter.profile_slope(std::clamp(r, least, most));
        };
        double piece_error = 0;
        value += length * quadrature.integrate(slope, 0., 1., 1e-12, &piece_error);
        error += length * piece_error;
        begin = end;
    };
    for (const double kink : indenter.kinks())
        if (kink < radius) add_piece(kink);
    add_piece(radius);
    if (!(error <= 1e-10 * value))
        throw contact::InputError(fmt::format(
            "indenter: the slope of its profile is too rough within r = {:.6g} m (relative error "
            "{:.3g} of the transform); smooth the profile or declare its kinks",
            radius, error / value));
    return value;
}

double transformed_profile(const contact::AxisymmetricIndenter& indenter, double x) {
    return x == 0 ? 0 : std::abs(x) * transformed_mean_slope(indenter, x);
}

}  // namespace tricontact::mdr

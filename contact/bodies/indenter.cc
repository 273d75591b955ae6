#include "contact/bodies/indenter.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <numbers>
#include <stdexcept>

#include "contact/base/error.h"

namespace tricontact::contact {

namespace {

double checked_radius(double radius) {
    if (!is_positive_and_finite(radius))
        throw InputError("indenter: the radius must be positive and finite");
    return radius;
}

/// ∫_0^(pi/2) h'(x sin t) weight(t) dt.
template <typename Weight>
double integral_of_slope(const AxisymmetricIndenter& indenter, double x, Weight weight) {
    if (!(x > 0 && x <= indenter.outer_radius()))
        throw std::domain_error("profile transform: x lies outside of the indenter");
    // Double exponential quadrature: indifferent to singularities at the ends of a piece.
    thread_local boost::math::quadrature::tanh_sinh<double> quadrature;  // keeps its abscissas
    double value = 0, magnitude = 0, error = 0, begin = 0;
    auto add_piece = [&](double end) {
        // Strictly inside of the piece: rounding must not read the slope beyond a kink or the rim.
        const double least = std::nextafter(begin, end), most = std::nextafter(end, begin);
        const double start = std::asin(begin / x), length = std::asin(end / x) - start;
        auto integrand = [&](double part) {
            const double t = start + part * length;
            return indenter.profile_slope(std::clamp(x * std::sin(t), least, most)) * weight(t);
        };
        double piece_error = 0, piece_magnitude = 0;
        value +=
            length * quadrature.integrate(integrand, 0., 1., 1e-12, &piece_error, &piece_magnitude);
        error += length * piece_error;
        magnitude += length * piece_magnitude;
        begin = end;
    };
    for (const double kink : indenter.kinks())
        if (kink < x) add_piece(kink);
    add_piece(x);
    if (!(error <= 1e-10 * magnitude))  // a body with a moat may have a transform of any sign
        throw InputError(fmt::format(
            "indenter: the slope of its profile is too rough within r = {:.6g} m (relative error "
            "{:.3g} of the transform); smooth the profile or declare its kinks",
            x, error / magnitude));
    return value;
}

}  // namespace

Vector2 AxisymmetricIndenter::slope(double x, double y) const {
    const double r = std::hypot(x, y);
    if (r == 0) return {0, 0};
    const double slope = profile_slope(r);
    return {slope * x / r, slope * y / r};
}

double AxisymmetricIndenter::slope_moment(double x, int k) const {
    return integral_of_slope(*this, x, [=](double t) { return std::pow(x * std::sin(t), k); });
}

double AxisymmetricIndenter::centre_pressure(double x) const {
    if (profile_slope(0) > 0) return infinity;
    // acos(sin t) = pi/2 - t; both factors of h' have the slope's zero at the centre to live on.
    auto weight = [](double t) { return 1 + (std::numbers::pi / 2 - t) / std::tan(t); };
    return integral_of_slope(*this, x, weight) / std::numbers::pi;
}

Paraboloid::Paraboloid(double radius) : radius_(checked_radius(radius)) {}

Sphere::Sphere(double radius) : radius_(checked_radius(radius)) {}

}  // namespace tricontact::contact

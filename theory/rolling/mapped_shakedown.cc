#include "theory/rolling/mapped_shakedown.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "theory/arguments.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::theory {

namespace {

using boost::math::quadrature::gauss;
using std::numbers::pi;

constexpr double largest_mapped_amplitude = .85;
constexpr double small_mapping = 3 / pi;  // kappa of small loads and amplitudes, nu = 0

// Of small loads and amplitudes below that of MDR.
double largest_deficit(const MappedRolling& p) {
    return mdr_mapping - small_mapping * (1 - orientation(p) / 3);
}

double limit_fraction(const MappedRolling& p) {
    return std::min(1., p.tangential_ratio / shakedown_limit(p.amplitude_ratio));
}

double arithmetic_geometric_mean(double a, double b) {
    // Quadratic: the difference of 1 is gone after five steps.
    for (int step = 0; step < 8; ++step) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}

}  // namespace

void check(const MappedRolling& p) {
    if (!(p.amplitude_ratio >= 0 && p.amplitude_ratio <= largest_mapped_amplitude))
        throw std::domain_error("mapped rolling: w = W/a must lie in [0, 0.85]");
    check_unit_interval("mapped rolling", "f = F_T/(mu F_N)", p.tangential_ratio);
    if (!std::isfinite(p.angle))
        throw std::domain_error("mapped rolling: the angle must be finite");
    if (!(p.poisson >= 0 && p.poisson <= .5))
        throw std::domain_error("mapped rolling: nu must lie in [0, 1/2]");
}

double orientation(const MappedRolling& p) {
    return p.poisson / (2 - p.poisson) * std::cos(2 * p.angle);
}

double half_space_mapping(const MappedRolling& p) {
    check(p);
    const double w = p.amplitude_ratio, unloaded = 1 - limit_fraction(p) * (1 - .06 * w);
    return mdr_mapping -
           largest_deficit(p) * std::pow(1 - w, .42) * std::pow(unloaded, .19 + .05 * w);
}

double simple_half_space_mapping(const MappedRolling& p) {
    check(p);
    return mdr_mapping - largest_deficit(p) * std::pow(1 - p.amplitude_ratio, .43) *
                             std::pow(1 - limit_fraction(p), .18);
}

std::optional<double> half_space_settled_shift_ratio(const MappedRolling& p) {
    const double kappa = half_space_mapping(p);
    if (p.tangential_ratio > shakedown_limit(p.amplitude_ratio)) return std::nullopt;
    return settled_shift_ratio(p.amplitude_ratio, p.tangential_ratio, kappa);
}

double small_amplitude_mapping(const MappedRolling& p) {
    check(p);
    const double c = std::cbrt(1 - p.tangential_ratio);
    if (c == 1) return small_mapping * (1 - orientation(p) / 3);
    if (c == 0) return mdr_mapping;
    const auto second = [](double s) { return boost::math::ellint_2(std::sqrt(1 - s * s)); };
    const double modulus = std::sqrt((1 - c) * (1 + c));
    // In s = t^2 the integrand's s^2 ln s at zero is smooth enough for 1e-12.
    const auto integrand = [&](double t) { return 2 * t * second(t * t); };
    const double taken = gauss<double, 30>::integrate(integrand, std::sqrt(c), 1.);
    const double rest = second(c) - c * c * boost::math::ellint_1(modulus);
    return 12 / (pi * pi) * (taken - orientation(p) / 3 * c * rest) / ((1 - c) * (1 + c));
}

double small_load_mapping(double w, const RolledLaw& law) {
    if (!(w > 0 && w < 1)) throw std::domain_error("small_load_mapping: w must lie in (0, 1)");
    // The lens has the semi-axes 1 - w and sqrt(1 - w^2).
    const double area = 2 / pi * (std::acos(w) - w * std::sqrt((1 - w) * (1 + w)));
    const double aspect = std::pow((1 + w) / (1 - w), .25);
    const double radius = std::sqrt(area) * arithmetic_geometric_mean(aspect, 1 / aspect);
    return law.mdr_mapping * (1 - radius) / w;
}

double largest_settled_shift_ratio(const MappedRolling& p) {
    check(p);
    const double w = p.amplitude_ratio;
    const auto shift = [&](double phi) {
        const double across = 1 - std::pow(w * std::sin(phi), 2), along = w * std::cos(phi);
        const double ray =
            across * std::acos(along / std::sqrt(across)) - along * std::sqrt((1 - w) * (1 + w));
        return ray * (1 + orientation(p) * std::cos(2 * phi));
    };
    return 4 / (pi * pi) * gauss<double, 30>::integrate(shift, 0., pi / 2);
}

}  // namespace tricontact::theory

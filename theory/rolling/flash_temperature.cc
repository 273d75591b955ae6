#include "theory/rolling/flash_temperature.h"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::theory {

namespace {

/// e^u K_0(|u|), by its asymptote where that is exact to 1e-4 of its correction 1/(8 u).
double line_source(double u) {
    constexpr double far = 300;
    if (u > far) return std::sqrt(std::numbers::pi / (2 * u)) * (1 - 1 / (8 * u));
    return u < -far ? 0 : std::exp(u) * boost::math::cyl_bessel_k(0, std::abs(u));
}

/// Integral of it around its logarithmic pole at 0.
double line_sources(double begin, double end) {
    constexpr double nothing_ahead = -40;
    boost::math::quadrature::tanh_sinh<double> rule;
    double sum = 0;
    for (const auto& [low, high] :
         {std::pair{std::clamp(begin, nothing_ahead, 0.), std::clamp(end, nothing_ahead, 0.)},
          std::pair{std::max(begin, 0.), std::max(end, 0.)}})
        if (high > low)
            sum += rule.integrate([](double u) { return u == 0 ? 0 : line_source(u); }, low, high);
    return sum;
}

}  // namespace

double uniform_heating(double x) {
    return 2 * (std::sqrt(std::max(x + 1, 0.)) - std::sqrt(std::max(x - 1, 0.)));
}

double elliptic_heating(double x) {
    if (!(std::abs(x) <= 1)) throw std::domain_error("elliptic_heating: |x| > 1");
    const double m = (1 + x) / 2, k = std::sqrt(m);
    const double first = m < 1 ? (1 - m) * std::comp_ellint_1(k) : 0;
    return 4 * std::numbers::sqrt2 / 3 * ((2 * m - 1) * std::comp_ellint_2(k) + first);
}

double band_error(double peclet) {
    if (!(peclet > 0)) throw std::domain_error("band_error: Pe <= 0");
    const auto cooler = [&](double x) { return -line_sources(peclet * (x - 1), peclet * (x + 1)); };
    constexpr int bits = 20;  // of the place, twice as many of the highest value
    const auto [place, highest] = boost::math::tools::brent_find_minima(cooler, 0., 1., bits);
    return 2 * std::sqrt(std::numbers::pi * peclet) / -highest - 1;
}

}  // namespace tricontact::theory

#include "theory/rolling/kalker.h"

#include <algorithm>
#include <boost/math/interpolators/makima.hpp>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tricontact::theory {

namespace {

/// Of one ratio a/b: C11, C22, C23 and C33, each at nu = 0, 1/4, 1/2.
struct Row {
    double ratio;
    double coefficients[4][3];
};

// Kalker (1990), table E.3.
constexpr Row kalker_table[] = {
    {.1, {{2.51, 3.31, 4.85}, {2.51, 2.52, 2.53}, {.334, .473, .731}, {6.42, 8.28, 11.7}}},
    {.2, {{2.59, 3.37, 4.81}, {2.59, 2.63, 2.66}, {.483, .603, .809}, {3.46, 4.27, 5.66}}},
    {.3, {{2.68, 3.44, 4.80}, {2.68, 2.75, 2.81}, {.607, .715, .889}, {2.49, 2.96, 3.72}}},
    {.4, {{2.78, 3.53, 4.82}, {2.78, 2.88, 2.98}, {.720, .823, .977}, {2.02, 2.32, 2.77}}},
    {.5, {{2.88, 3.62, 4.83}, {2.88, 3.01, 3.14}, {.827, .929, 1.07}, {1.74, 1.93, 2.22}}},
    {.6, {{2.98, 3.72, 4.91}, {2.98, 3.14, 3.31}, {.930, 1.03, 1.18}, {1.56, 1.68, 1.86}}},
    {.7, {{3.09, 3.81, 4.97}, {3.09, 3.28, 3.48}, {1.03, 1.14, 1.29}, {1.43, 1.50, 1.60}}},
    {.8, {{3.19, 3.91, 5.05}, {3.19, 3.41, 3.65}, {1.13, 1.25, 1.40}, {1.34, 1.37, 1.42}}},
    {.9, {{3.29, 4.01, 5.12}, {3.29, 3.54, 3.82}, {1.23, 1.36, 1.51}, {1.27, 1.27, 1.27}}},
    {1, {{3.40, 4.12, 5.20}, {3.40, 3.67, 3.98}, {1.33, 1.47, 1.63}, {1.21, 1.19, 1.16}}},
    {1 / .9, {{3.51, 4.22, 5.30}, {3.51, 3.81, 4.16}, {1.44, 1.59, 1.77}, {1.16, 1.11, 1.06}}},
    {1 / .8, {{3.65, 4.36, 5.42}, {3.65, 3.99, 4.39}, {1.58, 1.75, 1.94}, {1.10, 1.04, .954}}},
    {1 / .7, {{3.82, 4.54, 5.58}, {3.82, 4.21, 4.67}, {1.76, 1.95, 2.18}, {1.05, .965, .852}}},
    {1 / .6, {{4.06, 4.78, 5.80}, {4.06, 4.50, 5.04}, {2.01, 2.23, 2.50}, {1.01, .892, .751}}},
    {1 / .5, {{4.37, 5.10, 6.11}, {4.37, 4.90, 5.56}, {2.35, 2.62, 2.96}, {.958, .819, .650}}},
    {1 / .4, {{4.84, 5.57, 6.57}, {4.84, 5.48, 6.31}, {2.88, 3.24, 3.70}, {.912, .747, .549}}},
    {1 / .3, {{5.57, 6.34, 7.34}, {5.57, 6.40, 7.51}, {3.79, 4.32, 5.01}, {.868, .674, .446}}},
    {1 / .2, {{6.96, 7.78, 8.82}, {6.96, 8.14, 9.79}, {5.72, 6.63, 7.89}, {.828, .601, .341}}},
    {1 / .1, {{10.7, 11.7, 12.9}, {10.7, 12.8, 16.0}, {12.2, 14.6, 18.0}, {.795, .526, .228}}},
};

/// The parabola of 1/C through the three nu of a row.
double at_poisson(const double (&c)[3], double nu) {
    const double at_0 = 8 * (nu - .25) * (nu - .5), at_quarter = -16 * nu * (nu - .5),
                 at_half = 8 * nu * (nu - .25);
    return 1 / (at_0 / c[0] + at_quarter / c[1] + at_half / c[2]);
}

double interpolated(std::size_t coefficient, double ratio, double nu) {
    std::vector<double> x, y;
    for (const Row& row : kalker_table) {
        x.push_back(std::log(row.ratio));
        y.push_back(std::log(at_poisson(row.coefficients[coefficient], nu)));
    }
    // 1/0.1 and 10 may differ in the last bit.
    const double at = std::clamp(std::log(ratio), x.front(), x.back());
    return std::exp(boost::math::interpolators::makima(std::move(x), std::move(y))(at));
}

}  // namespace

CombinedMaterial combined_material(const contact::MaterialPair& materials) {
    const double nu_over_g = materials.nu_over_g();
    const double one_over_g = materials.one_minus_nu_over_g() + nu_over_g;  // summed over bodies
    return {2 / one_over_g, nu_over_g / one_over_g};
}

KalkerCoefficients kalker_coefficients(double axes_ratio, double poisson) {
    if (!(axes_ratio >= .1 && axes_ratio <= 10))
        throw std::domain_error("kalker: a/b must lie between 0.1 and 10");
    if (!(poisson >= 0 && poisson <= .5))
        throw std::domain_error("kalker: Poisson's ratio must lie between 0 and 1/2");
    const auto at = [&](std::size_t coefficient) {
        return interpolated(coefficient, axes_ratio, poisson);
    };
    return {at(0), at(1), at(2), at(3)};
}

}  // namespace tricontact::theory

#include "comparisons/finite_strain/strain_threshold.h"

#include <math.h>  // pchip.hpp of Boost 1.74 uses ::isnan

#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <functional>

#include "contact/base/root.h"
#include "statistics/refined_grid.h"

namespace tricontact::comparisons {

namespace {

using Function = std::function<double(double)>;

constexpr std::size_t fewest_points = 4;  // of the interpolant
constexpr int threshold_bits = 40;

/// First passage from below zero to above, and whether there is one back behind it.
struct FirstRise {
    std::optional<double> at;
    bool from_begin = false, returns = false;
};

FirstRise first_rise(const Function& excess, const std::vector<double>& grid) {
    FirstRise rise;
    double before = excess(grid.front());
    rise.from_begin = before >= 0;
    for (std::size_t i = 1; i < grid.size(); ++i) {
        const double now = excess(grid[i]);
        const bool exceeded = rise.from_begin || rise.at;
        if (exceeded && now < 0) rise.returns = true;
        if (!exceeded && now >= 0)
            rise.at =
                contact::bracketed_root(excess, grid[i - 1], grid[i], before, now, threshold_bits);
        before = now;
    }
    return rise;
}

}  // namespace

std::optional<StrainThreshold> strain_threshold(std::vector<DeviationPoint> points,
                                                double tolerance, bool of_force) {
    if (of_force) points.insert(points.begin(), DeviationPoint{});
    if (points.size() < fewest_points) return {};
    std::vector<double> at, deviations, errors;
    for (const DeviationPoint& p : points) {
        at.push_back(of_force ? std::cbrt(p.at) : p.at);
        deviations.push_back(p.deviation);
        errors.push_back(p.error);
    }
    const std::vector<double> grid = statistics::refined_grid(at);
    using boost::math::interpolators::pchip;
    const pchip<std::vector<double>> deviation(std::vector<double>(at), std::move(deviations)),
        error(std::move(at), std::move(errors));
    const auto rise = [&](double sign) {
        return first_rise(
            [&](double x) { return std::abs(deviation(x)) + sign * error(x) - tolerance; }, grid);
    };
    const auto back = [&](std::optional<double> x) {
        return x && of_force ? std::optional(*x * *x * *x) : x;
    };
    const FirstRise value = rise(0);
    return StrainThreshold{back(value.at), value.from_begin, value.returns, back(rise(1).at),
                           back(rise(-1).at)};
}

}  // namespace tricontact::comparisons

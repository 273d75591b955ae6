#include "comparisons/half_space/needed_thickness.h"

#include <math.h>  // pchip.hpp of Boost 1.74 uses ::isnan

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <stdexcept>

#include "contact/base/root.h"
#include "statistics/refined_grid.h"

namespace tricontact::comparisons {

namespace {

using Function = std::function<double(double)>;

constexpr int thickness_bits = 40;

struct Crossings {
    std::optional<double> first;
    int n = 0;
};

/// Where `f` passes zero on a grid of increasing arguments.
Crossings crossings(const Function& f, const std::vector<double>& grid) {
    Crossings result;
    double before = f(grid.front());
    for (std::size_t i = 1; i < grid.size(); ++i) {
        const double now = f(grid[i]);
        if ((before < 0) != (now < 0)) {
            if (!result.first)
                result.first =
                    contact::bracketed_root(f, grid[i - 1], grid[i], before, now, thickness_bits);
            ++result.n;
        }
        before = now;
    }
    return result;
}

std::optional<double> inverse(std::optional<double> x) {
    return x ? std::optional(1 / *x) : std::nullopt;
}

/// Of the points over D_c/b, from the half-space, at which everything is 0, to the thinnest layer.
template <class Value>
std::vector<double> over_thinness(const std::vector<RatioPoint>& points, Value value) {
    std::vector<double> result{0};
    std::transform(points.rbegin(), points.rend(), std::back_inserter(result), value);
    return result;
}

}  // namespace

NeededThickness needed_thickness(const std::vector<RatioPoint>& points, const Function& exact,
                                 double tolerance) {
    const auto exceeds = [&](const RatioPoint& p) { return std::abs(p.ratio - 1) > tolerance; };
    const auto last = std::find_if(points.rbegin(), points.rend(), exceeds);
    if (last == points.rend()) return {};
    if (last == points.rbegin())
        throw std::domain_error("needed thickness: the thickest layer exceeds the tolerance");
    const auto excess = [&](double log_thickness) {
        return std::abs(exact(std::exp(log_thickness)) - 1) - tolerance;
    };
    NeededThickness result;
    const RatioPoint &thin = *last, &thick = *std::prev(last);
    result.ratio = std::exp(contact::bracketed_root(
        excess, std::log(thin.thickness_ratio), std::log(thick.thickness_ratio),
        std::abs(thin.ratio - 1) - tolerance, std::abs(thick.ratio - 1) - tolerance,
        thickness_bits));
    result.last_of_several = std::find_if_not(last, points.rend(), exceeds) != points.rend();
    return result;
}

NeededThickness needed_thickness(const std::vector<RatioPoint>& points, double tolerance) {
    if (points.size() < 3)
        throw std::domain_error("needed thickness: fewer than three points to interpolate");
    const auto thinness = over_thinness(points, [](auto& p) { return 1 / p.thickness_ratio; });
    const auto interpolant = [&](std::vector<double> values) {
        return boost::math::interpolators::pchip(std::vector<double>(thinness), std::move(values));
    };
    const auto deviation = interpolant(over_thinness(points, [](auto& p) { return p.ratio - 1; }));
    const auto error = interpolant(over_thinness(points, [](auto& p) { return p.error; }));
    const std::vector<double> grid = statistics::refined_grid(thinness);
    const auto sought = [&](double n_errors) {  // |deviation| plus so many errors
        const auto excess = [&](double s) {
            return std::abs(deviation(s)) + n_errors * error(s) - tolerance;
        };
        return crossings(excess, grid);
    };
    const Crossings central = sought(0);
    return {.ratio = inverse(central.first),
            .low = inverse(sought(-1).first),
            .high = inverse(sought(1).first),
            .last_of_several = central.n > 1};
}

}  // namespace tricontact::comparisons

#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace tricontact::comparisons {

/// The thickness over D_c from which on a quantity deviates by less than a tolerance: the last
/// crossing where there are several.
struct NeededThickness {
    std::optional<double> ratio = {};  ///< empty: the tolerance is never exceeded
    /// Interval of a computed one. `high` without `ratio`: the error leaves open whether it is
    /// exceeded below; without `low`: whether it is exceeded at all.
    std::optional<double> low = {}, high = {};
    bool last_of_several = false;  ///< thinner layers deviate less again
};

/// A ratio, layer over half-space, at one thickness over D_c.
struct RatioPoint {
    double thickness_ratio = 0;
    double ratio = 1;
    double error = 0;  ///< half width of its interval; 0: exact
};

/// Of an exact ratio known at `points` (thickness increasing): the crossing between two of them by
/// root finding on `exact` to 1e-12. A crossing and its return between neighbours are not
/// seen. Throws std::domain_error if the thickest point still exceeds the tolerance.
NeededThickness needed_thickness(const std::vector<RatioPoint>& points,
                                 const std::function<double(double)>& exact, double tolerance);

/// Of computed ratios alone: between them and to the half-space, where the ratio is 1, deviation
/// and error are monotone interpolants over D_c/b (PCHIP, Fritsch and Carlson 1980); nothing is
/// extrapolated. `low` and `high` are where the deviation less and plus its error cross. Throws
/// std::domain_error for fewer than three points.
NeededThickness needed_thickness(const std::vector<RatioPoint>& points, double tolerance);

}  // namespace tricontact::comparisons

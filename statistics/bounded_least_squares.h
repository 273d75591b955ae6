#pragma once

#include <functional>
#include <vector>

namespace tricontact::statistics {

/// Residuals over their standard errors at a point. Throws contact::InputError where there are
/// none.
using Residuals = std::function<std::vector<double>(const std::vector<double>& x)>;

/// A box; a variable whose bounds are equal is held there.
struct Bounds {
    std::vector<double> low, high;
};

/// Where a sum of squares is least within bounds, and how little that is.
struct BoundedFit {
    std::vector<double> x;
    double sum_of_squares = 0;
};

/// Levenberg's and Marquardt's method with steps projected onto the box (Kanzow, Yamashita and
/// Fukushima 2004, J. Comput. Appl. Math. 172, 375, the local method): a variable at a bound that
/// the slope drives outwards is held for the step. Variables are of the order of 1, such as
/// logarithms: no step exceeds 1 in any of them. Where there are no residuals, a step is taken
/// back. A valley on whose ground 20 steps gain less than 1e-9 of the sum, or beyond the 400th 100
/// steps less than 1e-3, is a minimum. Throws contact::NotConverged where there are no residuals at
/// `start`, or after 2000 steps.
BoundedFit fit_within(const Residuals& residuals, std::vector<double> start, const Bounds& bounds);

/// Slopes of the residuals by each variable that is not held, zero for the others: a column each.
/// Differences to both sides of a millionth, to one side at a bound.
std::vector<std::vector<double>> slopes(const Residuals& residuals, const std::vector<double>& x,
                                        const Bounds& bounds);

}  // namespace tricontact::statistics

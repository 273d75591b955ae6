#pragma once

#include <limits>
#include <vector>

namespace tricontact::comparisons {

/// A computed value with its numerical error bar.
struct Computed {
    double value = 0;
    double error = std::numeric_limits<double>::quiet_NaN();  ///< half width; NaN: not known

    bool has_bar() const { return error >= 0; }
};

/// Whether the bars exclude each other. False if one is not known: nothing can be said.
bool differs(const Computed& a, const Computed& b);

/// From values on finer and finer levels of resolution, sizes decreasing: `estimate_limit` from
/// three levels on. Two levels show no order: the finer value stays, its error is 1.25 times what
/// the first order, the least that contacts at square cells have, makes of their difference. One
/// level has no bar.
Computed value_of_levels(const std::vector<double>& sizes, const std::vector<double>& values);

/// From values with more and more steps in a quarter of the period, which they depend on to first
/// order (ratcheting): extrapolated from the last two. Error: what extrapolation from the two
/// before would have changed, or with two numbers of steps half of what it changes. One number of
/// steps has no bar.
Computed value_of_steps(const std::vector<int>& steps, const std::vector<double>& values);

}  // namespace tricontact::comparisons

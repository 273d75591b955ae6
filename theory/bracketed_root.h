#pragma once

#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <limits>
#include <numeric>

namespace tricontact::theory {

/// Root of a monotone function with a change of sign in [low, high], to full precision; both ends
/// may be roots.
template <typename Function>
double bracketed_root(Function function, double low, double high) {
    const double at_low = function(low), at_high = function(high);
    if (at_low == 0 || low == high) return low;
    if (at_high == 0) return high;
    const boost::math::tools::eps_tolerance<double> full_precision(
        std::numeric_limits<double>::digits - 1);
    std::uintmax_t evaluations = 200;  // toms748 needs about 10; bisection alone 53
    const auto [left, right] = boost::math::tools::toms748_solve(
        function, low, high, at_low, at_high, full_precision, evaluations);
    return std::midpoint(left, right);
}

}  // namespace tricontact::theory

#pragma once

#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <limits>
#include <numeric>

namespace tricontact::theory {

/// Root of a function whose values at the ends of [low, high] are known and differ in sign; one of
/// them may be the root. To so many bits: full precision.
template <typename Function>
double bracketed_root(Function function, double low, double high, double at_low, double at_high,
                      int bits = std::numeric_limits<double>::digits - 1) {
    if (at_low == 0 || low == high) return low;
    if (at_high == 0) return high;
    std::uintmax_t evaluations = 200;  // toms748 needs about 10; bisection alone 53
    const auto [left, right] = boost::math::tools::toms748_solve(
        function, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(bits),
        evaluations);
    return std::midpoint(left, right);
}

/// The same of a function whose values there are not known yet.
template <typename Function>
double bracketed_root(Function function, double low, double high,
                      int bits = std::numeric_limits<double>::digits - 1) {
    const double at_low = function(low), at_high = function(high);
    return bracketed_root(function, low, high, at_low, at_high, bits);
}

}  // namespace tricontact::theory

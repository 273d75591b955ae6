#pragma once

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

// Roots of functions of one variable (Alefeld, Potra and Shi 1995, algorithm 748).
namespace tricontact::contact {

/// Bits of a root to full precision.
inline constexpr int root_bits = std::numeric_limits<double>::digits - 1;

/// Root of a function whose values at the ends of [low, high] are known and differ in sign; one of
/// them may be the root. To so many bits.
template <typename Function>
double bracketed_root(Function function, double low, double high, double at_low, double at_high,
                      int bits = root_bits) {
    if (at_low == 0 || low == high) return low;
    if (at_high == 0) return high;
    std::uintmax_t evaluations = 300;  // about 10 are needed; bisection alone 53
    const auto [left, right] = boost::math::tools::toms748_solve(
        function, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(bits),
        evaluations);
    return std::midpoint(left, right);
}

/// The same of a function whose values there are not known yet.
template <typename Function>
double bracketed_root(Function function, double low, double high, int bits = root_bits) {
    const double at_low = function(low), at_high = function(high);
    return bracketed_root(function, low, high, at_low, at_high, bits);
}

/// Root in (0, largest] of an increasing function, negative near 0, searched from `start` > 0 on,
/// to full precision; empty if it lies beyond `largest` (which may be infinite).
template <typename Function>
std::optional<double> increasing_root(Function function, double start, double largest) {
    double low = 0, high = std::min(start, largest);
    while (!(function(high) >= 0)) {
        if (high >= largest) return {};
        low = high;
        high = std::min(2 * high, largest);
    }
    if (low == 0)  // a bracket from 0 on would bisect towards the order of magnitude
        for (low = high / 2; function(low) >= 0; low /= 2) high = low;
    return bracketed_root(function, low, high);
}

}  // namespace tricontact::contact

#pragma once

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

namespace tricontact::contact {

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
    const boost::math::tools::eps_tolerance<double> full_precision(
        std::numeric_limits<double>::digits - 1);
    std::uintmax_t evaluations = 300;
    const auto [left, right] =
        boost::math::tools::toms748_solve(function, low, high, full_precision, evaluations);
    return std::midpoint(left, right);
}

}  // namespace tricontact::contact

#pragma once

#include <cmath>
#include <limits>

namespace tricontact::contact {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// A number that is not known, or does not exist.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

inline bool is_positive_and_finite(double value) {
    return value > 0 && std::isfinite(value);
}

/// The larger of two numbers, NaN if either is one: what has broken never hides behind what is
/// sound, as it does with std::max.
inline double larger(double a, double b) {
    return a >= b || std::isnan(a) ? a : b;
}

}  // namespace tricontact::contact

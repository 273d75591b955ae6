#pragma once

#include <cmath>

namespace tricontact::contact {

/// The larger of two numbers, NaN if either is one: what has broken never hides behind what is
/// sound, as it does with std::max.
inline double larger(double a, double b) {
    return a >= b || std::isnan(a) ? a : b;
}

}  // namespace tricontact::contact

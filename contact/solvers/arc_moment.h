#pragma once

#include <cmath>

namespace tricontact::contact {

/// ∫_u^v r^k/sqrt(x^2 - r^2) dr [m^k], 0 <= u <= v <= x, k >= 0, by the recurrence
///   k M_k = (k - 1) x^2 M_(k-2) - [r^(k-1) sqrt(x^2 - r^2)]_u^v.
inline double arc_moment(double x, double u, double v, int k) {
    const double at_u = std::sqrt((x - u) * (x + u)), at_v = std::sqrt((x - v) * (x + v));
    if (k == 0) return std::atan2(v, at_v) - std::atan2(u, at_u);
    if (k == 1) return at_u - at_v;
    const double ends = std::pow(u, k - 1) * at_u - std::pow(v, k - 1) * at_v;
    return ((k - 1) * x * x * arc_moment(x, u, v, k - 2) + ends) / k;
}

}  // namespace tricontact::contact

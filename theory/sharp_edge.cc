#include "theory/sharp_edge.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/base/root.h"

namespace tricontact::theory {

double edge_pressure_exponent(double wedge_angle, double dundurs_alpha) {
    constexpr double pi = std::numbers::pi;
    if (!(wedge_angle > 0 && wedge_angle < pi))
        throw std::domain_error("sharp edge: the angle must lie between 0 and pi");
    if (!(std::abs(dundurs_alpha) <= 1))
        throw std::domain_error("sharp edge: Dundurs' alpha must lie in [-1, 1]");
    const auto characteristic = [&](double lambda) {
        const double wedge = std::sin(lambda * wedge_angle);
        const double edge = lambda * std::sin(wedge_angle);
        return (1 + dundurs_alpha) * std::cos(pi * lambda) * (wedge * wedge - edge * edge) +
               (1 - dundurs_alpha) / 2 * std::sin(pi * lambda) *
                   (std::sin(2 * lambda * wedge_angle) + lambda * std::sin(2 * wedge_angle));
    };
    // lambda = 1 is always a root: no singularity, unless one lies below it.
    const double low = 0.5, high = 1 - 1e-6;
    const double at_low = characteristic(low), at_high = characteristic(high);
    if (dundurs_alpha == 1) return -0.5;  // cos(pi lambda) = 0
    if (at_low * at_high >= 0) return 0;
    return contact::bracketed_root(characteristic, low, high, at_low, at_high, 48) - 1;
}

}  // namespace tricontact::theory

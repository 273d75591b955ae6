#include "theory/rolling/hunter.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "theory/bracketed_root.h"

namespace tricontact::theory {

namespace {

constexpr double far = 100;  // from here on four terms of the asymptotic series are exact to 1e-8

/// I_1/I_0.
double ratio_i(double z) {
    if (z < far) return std::cyl_bessel_i(1, z) / std::cyl_bessel_i(0, z);
    return 1 - 1 / (2 * z) - 1 / (8 * z * z) - 1 / (8 * z * z * z);
}

/// K_0/K_1.
double ratio_k(double y) {
    if (y < far) return std::cyl_bessel_k(0, y) / std::cyl_bessel_k(1, y);
    return 1 - 1 / (2 * y) + 3 / (8 * y * y) - 3 / (8 * y * y * y);
}

struct Contact {
    double force, lead;  // [N/m], [m]
};

// With lambda = v tau and Lambda = (1 + g) lambda, sigma = p - lambda p' solves Flamant's equation
// about the contact's middle m ahead of the cylinder's lowest point,
//   sigma = E*/(2R) [sqrt(l^2 - s^2) + ((Lambda - m) s + B)/sqrt(l^2 - s^2)];
// p vanishes at the trailing edge, and the surface arrives at the leading edge with the cylinder's
// slope:
//   B = g lambda l I_1/(I_0 + I_1 K_0/K_1),   m = (B/l) K_0/K_1,   I of l/lambda, K of l/Lambda.
Contact contact_of(const HunterRolling& r, double l) {
    const double lambda = r.relaxation_way, all = (1 + r.ratio) * lambda;
    const double k = ratio_k(l / all), i = ratio_i(l / lambda);
    const double b = r.ratio * lambda * l * i / (1 + i * k), m = b * k / l;
    const double unit = std::numbers::pi * r.effective_modulus / (2 * r.radius);
    const double force = unit * (l * l / 2 + b);
    return {force, m + (all - m) * unit * l * l / 2 / force - lambda};
}

}  // namespace

HunterContact hunter_contact(const HunterRolling& r, double force_per_length) {
    for (const double value :
         {r.effective_modulus, r.radius, r.ratio, r.relaxation_way, force_per_length})
        if (!(value > 0 && std::isfinite(value)))
            throw std::domain_error("hunter: all values must be positive");
    // Hertz' half lengths on the relaxed half-space, and on the one at once.
    const double longest =
        std::sqrt(4 * r.radius * force_per_length / (std::numbers::pi * r.effective_modulus));
    const double shortest = longest / std::sqrt(1 + r.ratio);
    const double l = bracketed_root(
        [&](double length) { return contact_of(r, length).force - force_per_length; },
        shortest * (1 - 1e-6), longest * (1 + 1e-6));
    return {l, contact_of(r, l).lead};
}

}  // namespace tricontact::theory

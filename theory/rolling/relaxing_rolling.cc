#include "theory/rolling/relaxing_rolling.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/base/root.h"

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

using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;

/// p R/k [m^2].
double pressure(const FoundationRolling& r, double a, double x) {
    double sum = (a - x) * (a + x) / 2;
    for (const auto& [ratio, time] : r.relaxation.branches) {
        const double way = r.speed * time, s = (x - a) / way, grown = std::expm1(s);
        sum += ratio * way * (way * (s - grown) - a * grown);
    }
    return sum;
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
    const double l = contact::bracketed_root(
        [&](double length) { return contact_of(r, length).force - force_per_length; },
        shortest * (1 - 1e-6), longest * (1 + 1e-6));
    return {l, contact_of(r, l).lead};
}

FoundationContact foundation_contact(const FoundationRolling& r, double leading_edge) {
    for (const double value : {r.speed, r.stiffness, r.radius, leading_edge})
        if (!(value > 0 && std::isfinite(value)))
            throw std::domain_error("foundation: all values must be positive");
    const double a = leading_edge;
    // Just behind the leading edge p grows with (a - x); behind -a nothing presses.
    const double b =
        contact::bracketed_root([&](double x) { return pressure(r, a, x); }, -a, a * (1 - 1e-9));
    constexpr int most_halvings = 15;
    constexpr double accuracy = 1e-12;
    const auto integral = [&](auto&& f) {
        return Quadrature::integrate(f, b, a, most_halvings, accuracy);
    };
    const double sum = integral([&](double x) { return pressure(r, a, x); });
    const double moment = integral([&](double x) { return x * pressure(r, a, x); });
    return {a, b, r.stiffness / r.radius * sum, moment / sum};
}

FoundationContact foundation_contact_under(const FoundationRolling& r, double force) {
    if (!(force > 0 && std::isfinite(force)))
        throw std::domain_error("foundation: the force must be positive");
    // Elastic, 2/3 k a^3/R: relaxed the contact is longer than this, stiff at once shorter.
    const double relaxed = std::cbrt(1.5 * force * r.radius / r.stiffness);
    const double least = relaxed / std::cbrt(2 * r.relaxation.instantaneous_ratio());
    const double a = contact::bracketed_root(
        [&](double edge) { return foundation_contact(r, edge).force - force; }, least, 2 * relaxed);
    return foundation_contact(r, a);
}

FoundationRolling mdr_foundation(const contact::Relaxation& relaxation, double speed,
                                 double effective_modulus, double radius) {
    return {relaxation, speed, effective_modulus, radius / 2};
}

}  // namespace tricontact::theory

#include "theory/rolling/foundation_rolling.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <stdexcept>

#include "theory/bracketed_root.h"

namespace tricontact::theory {

namespace {

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

FoundationContact foundation_contact(const FoundationRolling& r, double leading_edge) {
    for (const double value : {r.speed, r.stiffness, r.radius, leading_edge})
        if (!(value > 0 && std::isfinite(value)))
            throw std::domain_error("foundation: all values must be positive");
    const double a = leading_edge;
    // Just behind the leading edge p grows with (a - x); behind -a nothing presses.
    const double b =
        bracketed_root([&](double x) { return pressure(r, a, x); }, -a, a * (1 - 1e-9));
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
    const double a = bracketed_root(
        [&](double edge) { return foundation_contact(r, edge).force - force; }, least, 2 * relaxed);
    return foundation_contact(r, a);
}

FoundationRolling mdr_foundation(const contact::Relaxation& relaxation, double speed,
                                 double effective_modulus, double radius) {
    return {relaxation, speed, effective_modulus, radius / 2};
}

}  // namespace tricontact::theory

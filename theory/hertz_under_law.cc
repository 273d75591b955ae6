#include "theory/hertz_under_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/base/special_values.h"
#include "contact/half_space_scales.h"

namespace tricontact::theory {

namespace {

constexpr double quarter_turn = std::numbers::pi / 2;
constexpr int stick_bits = 46;

/// ∫_0^angle sin^m, angle in [0, pi/2].
double sine_integral(double m, double angle) {
    const double sine = std::sin(angle), cosine = std::cos(angle);
    if (m == 2) return (angle - sine * cosine) / 2;
    if (m == 3) {
        const double versine = 2 * std::pow(std::sin(angle / 2), 2);
        return versine * versine * (2 + cosine) / 3;
    }
    // Not in long double, which costs three times as much.
    using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
    const double order = (m + 1) / 2;
    if (angle < quarter_turn / 2) return boost::math::beta(order, .5, sine * sine, InDouble()) / 2;
    // Near the quarter turn by its complement, which rounding of sin^2 does not touch.
    return (boost::math::beta(order, .5, InDouble()) -
            boost::math::beta(.5, order, cosine * cosine, InDouble())) /
           2;
}

}  // namespace

HertzUnderLaw::HertzUnderLaw(const contact::Friction& friction, double contact_radius,
                             double peak_pressure, double effective_shear_modulus)
    : radius_(contact_radius),
      shear_modulus_(effective_shear_modulus),
      strength_(friction.shear_strength.value_or(0)),
      exponent_(friction.pressure_exponent.value_or(1)),
      rising_(0),
      cap_(friction.strength_limit.value_or(contact::infinity)),
      capped_from_(1),
      chord_(sine_integral(exponent_ + 1, quarter_turn)) {
    const double reference = friction.reference_pressure.value_or(peak_pressure);
    rising_ = friction.coefficient.value_or(0) * reference *
              std::pow(peak_pressure / reference, exponent_);
    if (strength_ + rising_ > cap_)
        capped_from_ = std::pow(std::max(0., cap_ - strength_) / rising_, 1 / exponent_);
}

namespace {

/// Scales that friction has no part in, without what others of them cost.
contact::HalfSpaceScales pressed_scales(contact::Case c) {
    c.friction = {.coefficient = 1};
    return contact::half_space_scales(c);
}

HertzUnderLaw of_case(const contact::Case& c) {
    const contact::HalfSpaceScales hertz = pressed_scales(c);
    return {c.friction, hertz.contact_radius, hertz.peak_pressure,
            c.materials().effective_shear_modulus()};
}

}  // namespace

HertzUnderLaw::HertzUnderLaw(const contact::Case& c) : HertzUnderLaw(of_case(c)) {}

/// ∫ (tau - tau_cap) y dy/sqrt(Y^2 - y^2) from where tau is above it.
double HertzUnderLaw::excess_bound(double root) const {
    if (root <= capped_from_) return 0;
    const double beyond = std::sqrt((root - capped_from_) * (root + capped_from_));
    const double below = sine_integral(exponent_ + 1, std::asin(capped_from_ / root));
    return (strength_ - cap_) * beyond + rising_ * std::pow(root, exponent_ + 1) * (chord_ - below);
}

double HertzUnderLaw::bound(double root) const {
    return strength_ * root + rising_ * chord_ * std::pow(root, exponent_ + 1) - excess_bound(root);
}

/// The excess begins with the power 3/2 of the angle, smooth in its root.
double HertzUnderLaw::cut_off(double angle) const {
    const double begin = std::asin(capped_from_), span = angle - begin;
    if (!(span > 0)) return 0;
    return boost::math::quadrature::gauss<double, 12>::integrate(
        [&](double s) {
            const double sine = std::sin(begin + span * s * s);
            return excess_bound(sine) * sine * 2 * s * span;
        },
        0., 1.);
}

double HertzUnderLaw::force(double angle) const {
    const double sine = std::sin(angle);
    const double slipping = strength_ * sine_integral(2, angle) +
                            rising_ * chord_ * sine_integral(exponent_ + 2, angle) - cut_off(angle);
    return 4 * radius_ * radius_ * (std::cos(angle) * bound(sine) + slipping);
}

double HertzUnderLaw::bound_ratio(double angle) const {
    return bound(std::sin(angle)) / bound(1);
}

double HertzUnderLaw::force_ratio(double angle) const {
    return force(angle) / (2 * radius_ * radius_ * bound(1));
}

double HertzUnderLaw::friction_limit() const {
    // ∫ tau 2 pi r dr, r dr = -a^2 y dy.
    const double y = capped_from_;
    double sum = strength_ * y * y / 2 + rising_ * std::pow(y, exponent_ + 2) / (exponent_ + 2);
    if (y < 1) sum += cap_ * (1 - y) * (1 + y) / 2;
    return 2 * std::numbers::pi * radius_ * radius_ * sum;
}

double HertzUnderLaw::unit_shift() const {
    return 2 * radius_ * bound(1) / shear_modulus_;
}

double HertzUnderLaw::shift(double wanted) const {
    const double limit = friction_limit();
    if (!(wanted <= limit))
        throw contact::InputError(fmt::format(
            "friction: F_T = {:.6g} N is above what friction carries, {:.6g} N", wanted, limit));
    if (wanted <= 0) return 0;
    const double angle = contact::bracketed_root([&](double at) { return force(at) - wanted; }, 0.,
                                                 quarter_turn, -wanted, limit - wanted, stick_bits);
    return 2 * radius_ * bound(std::sin(angle)) / shear_modulus_;
}

}  // namespace tricontact::theory

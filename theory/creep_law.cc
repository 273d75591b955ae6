#include "theory/creep_law.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/base/root.h"

namespace tricontact::theory {

namespace {

/// Hertz' ellipse of half width 1.
double ellipse(double x) {
    return std::abs(x) < 1 ? std::sqrt((1 - x) * (1 + x)) : 0;
}

/// Of a rigid body on one with nu = -1; 1/2 bounds beta for nu >= 0 alone.
constexpr double largest_beta = .75;

void check(double beta) {
    if (!(std::abs(beta) <= largest_beta))
        throw std::domain_error("free rolling: Dundurs' beta must lie between -3/4 and 3/4");
}

}  // namespace

double cubic_force_ratio(double creepage_ratio) {
    if (!(creepage_ratio >= 0))
        throw std::domain_error("creep law: the creepage must not be negative");
    return creepage_ratio < 1 ? 1 - std::pow(1 - creepage_ratio, 3) : 1;
}

double cubic_creepage_ratio(double f) {
    if (!(f >= 0 && f <= 1)) throw std::domain_error("creep law: f must lie between 0 and 1");
    return 1 - std::cbrt(1 - f);
}

double vermeulen_johnson_coefficient(double poisson) {
    return 16 / (4 - 3 * poisson);
}

double mdr_coefficient(double poisson) {
    return 4 / (2 - poisson);
}

double sliding_creepage(double friction_limit, double shear_modulus, double area,
                        double coefficient) {
    return 3 * friction_limit / (shear_modulus * area * coefficient);
}

double carter_stick_ratio(double f) {
    if (!(f >= 0 && f <= 1)) throw std::domain_error("carter: f must lie between 0 and 1");
    return std::sqrt(1 - f);
}

double carter_creepage_ratio(double f) {
    return f / (1 + carter_stick_ratio(f));  // 1 - sqrt(1 - f) without cancellation
}

double carter_force_ratio(double creepage_ratio) {
    if (!(creepage_ratio >= 0))
        throw std::domain_error("carter: the creepage must not be negative");
    return creepage_ratio < 1 ? creepage_ratio * (2 - creepage_ratio) : 1;
}

double carter_traction(double x, double f) {
    const double c = carter_stick_ratio(f);
    if (std::isnan(x)) throw std::domain_error("carter: the position is no number");
    return c > 0 ? ellipse(x) - c * ellipse((x - 1 + c) / c) : ellipse(x);
}

double strength_stick_ratio(double f) {
    if (!(f >= 0 && f <= 1)) throw std::domain_error("creep law: f must lie between 0 and 1");
    return (1 - f) * (1 + f);
}

double strength_creepage_ratio(double f) {
    if (!(f >= 0 && f < 1)) throw std::domain_error("creep law: f must lie in [0, 1)");
    return std::atanh(f);
}

double strength_force_ratio(double creepage_ratio) {
    if (!(creepage_ratio >= 0))
        throw std::domain_error("creep law: the creepage must not be negative");
    return std::tanh(creepage_ratio);
}

double strength_traction(double x, double f) {
    const double begin = 1 - 2 * strength_stick_ratio(f);
    if (std::isnan(x)) throw std::domain_error("creep law: the position is no number");
    if (std::abs(x) > 1) return 0;
    if (x <= begin) return 1;
    return 2 / std::numbers::pi * std::atan(f * std::sqrt((1 - x) / (x - begin)));
}

double strength_bed_force_ratio(double eta) {
    if (!(eta >= 0)) throw std::domain_error("creep law: the creepage must not be negative");
    return 2 / std::numbers::pi * (std::atan(eta) + eta / (1 + eta * eta));
}

double strength_bed_creepage_ratio(double f) {
    if (!(f >= 0 && f < 1)) throw std::domain_error("creep law: f must lie in [0, 1)");
    // In s = eta/(1 + eta) of [0, 1).
    const auto excess = [f](double s) {
        return s < 1 ? strength_bed_force_ratio(s / (1 - s)) - f : 1 - f;
    };
    const double s = contact::bracketed_root(excess, 0, 1);
    return s / (1 - s);
}

double rough_free_creepage(double beta) {
    check(beta);
    const double e = std::atanh(beta) / std::numbers::pi;
    return 2 * e / std::sqrt(1 + 4 * e * e);
}

double smooth_free_creepage(double beta) {
    check(beta);
    // |x| < y a carries half of Hertz' load: (2/pi) (asin y + y sqrt(1 - y^2)) = 1/2.
    const double y = contact::bracketed_root(
        [](double s) {
            return std::asin(s) + s * std::sqrt((1 - s) * (1 + s)) - std::numbers::pi / 4;
        },
        0, 1);
    return beta * std::sqrt((1 - y) * (1 + y));
}

}  // namespace tricontact::theory

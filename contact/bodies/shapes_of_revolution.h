#pragma once

#include <algorithm>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "contact/base/error.h"
#include "contact/bodies/indenter.h"

namespace tricontact::contact {

/// k_n = g(x)/(c |x|^n) of the power law: n sqrt(pi)/2 Gamma(n/2)/Gamma((n+1)/2); 2 for a
/// paraboloid, pi/2 for a cone. Popov and Hess (2015), eq. 3.31. `n` >= 1, else std::domain_error.
inline double power_law_factor(double n) {
    if (!(n >= 1) || !std::isfinite(n))
        throw std::domain_error("power_law_factor: the exponent must be at least 1");
    // Gamma overflows beyond 171: logarithms
    const double ratio = std::exp(std::lgamma(n / 2) - std::lgamma((n + 1) / 2));
    return n * std::sqrt(std::numbers::pi) / 2 * ratio;
}

/// h = c r^n: a cone for n = 1, a paraboloid for n = 2, flatter in the middle beyond.
class PowerLaw final : public AxisymmetricIndenter {
  public:
    /// `coefficient` c > 0 [m^(1-n)], `exponent` n >= 1; InputError otherwise.
    PowerLaw(double coefficient, double exponent) : coefficient_(coefficient), exponent_(exponent) {
        if (!is_positive_and_finite(coefficient))
            throw InputError(
                "indenter: the coefficient of a power law must be positive and finite");
        if (!(exponent >= 1) || !std::isfinite(exponent))
            throw InputError("indenter: the exponent of a power law must be at least 1");
    }
    double coefficient() const { return coefficient_; }
    double exponent() const { return exponent_; }
    double profile(double r) const override { return coefficient_ * std::pow(r, exponent_); }
    double profile_slope(double r) const override {
        return coefficient_ * exponent_ * std::pow(r, exponent_ - 1);
    }
    bool presses_like_a_ball() const override { return exponent_ == 2 || exponent_ == 4; }
    /// Sneddon (1965): g = c k_n x^n, F_N = 2 n/(n + 1) E* x g, p(0) = n/(n - 1) E* g/(pi x).
    double slope_moment(double x, int k) const override {
        const double mean_slope =
            coefficient_ * power_law_factor(exponent_) * std::pow(x, exponent_ - 1);
        return k == 0 ? mean_slope : exponent_ / (exponent_ + 1) * x * x * mean_slope;
    }
    double centre_pressure(double x) const override {
        if (exponent_ == 1) return infinity;
        return exponent_ / (exponent_ - 1) * slope_moment(x, 0) / std::numbers::pi;
    }

  private:
    double coefficient_, exponent_;
};

/// Flat cylindrical punch whose edge is rounded: h = 0 up to the flat radius b, (r - b)^2/(2 R)
/// beyond. Schubert (1942); Ciavarella (1999), J. Strain Anal. 34.
class RoundedPunch final : public AxisymmetricIndenter {
  public:
    /// `flat_radius` b, `radius` R > 0 [m]; InputError otherwise.
    RoundedPunch(double flat_radius, double radius) : flat_radius_(flat_radius), radius_(radius) {
        if (!is_positive_and_finite(flat_radius) || !is_positive_and_finite(radius))
            throw InputError("indenter: both radii of a rounded punch must be positive and finite");
    }
    double profile(double r) const override {
        const double beyond = std::max(0., r - flat_radius_);
        return beyond * beyond / (2 * radius_);
    }
    double profile_slope(double r) const override {
        return std::max(0., r - flat_radius_) / radius_;
    }
    std::vector<double> kinks() const override { return {flat_radius_}; }
    bool presses_like_a_ball() const override { return false; }
    /// g = x/R [sqrt(x^2 - b^2) - b acos(b/x)].
    double slope_moment(double x, int k) const override {
        if (x <= flat_radius_) return 0;
        return (arc_moment(x, flat_radius_, x, k + 1) -
                flat_radius_ * arc_moment(x, flat_radius_, x, k)) /
               radius_;
    }

  private:
    double flat_radius_, radius_;
};

/// Flat cylindrical punch with a sharp edge: h = 0 up to its radius b, where it ends. Its contact
/// is complete, and no radius belongs to a load.
class FlatPunch final : public AxisymmetricIndenter {
  public:
    /// `radius` b > 0 [m]; InputError otherwise.
    explicit FlatPunch(double radius) : radius_(radius) {
        if (!is_positive_and_finite(radius))
            throw InputError("indenter: the radius of a punch must be positive and finite");
    }
    double profile(double) const override { return 0; }
    double profile_slope(double) const override { return 0; }
    double outer_radius() const override { return radius_ * (1 + 1e-9); }

  private:
    double radius_;
};

/// The section of a punch along y, |y| <= L/2: that of the punch of revolution.
class LongPunch final : public Indenter {
  public:
    /// `length` L > 0 [m]; InputError otherwise.
    LongPunch(std::unique_ptr<AxisymmetricIndenter> section, double length)
        : section_(std::move(section)), length_(length) {
        if (!is_positive_and_finite(length))
            throw InputError("indenter: the length must be positive and finite");
    }
    double height(double x, double y) const override {
        return std::abs(y) <= length_ / 2 ? section_->height(x, 0) : infinity;
    }
    Vector2 slope(double x, double) const override { return section_->slope(x, 0); }
    bool presses_like_a_ball() const override { return section_->presses_like_a_ball(); }

  private:
    std::unique_ptr<AxisymmetricIndenter> section_;
    double length_;
};

}  // namespace tricontact::contact

#pragma once

#include "contact/bodies/indenter.h"

namespace tricontact::contact {

/// h = c r^n: a cone for n = 1, a paraboloid for n = 2, flatter in the middle beyond.
class PowerLaw final : public AxisymmetricIndenter {
  public:
    /// `coefficient` c > 0 [m^(1-n)], `exponent` n >= 1; InputError otherwise.
    PowerLaw(double coefficient, double exponent);
    double coefficient() const { return coefficient_; }
    double exponent() const { return exponent_; }
    double profile(double r) const override;
    double profile_slope(double r) const override;
    double outer_radius() const override;
    bool presses_like_a_ball() const override { return exponent_ == 2 || exponent_ == 4; }
    /// Sneddon (1965): g = c k_n x^n, F_N = 2 n/(n + 1) E* x g, p(0) = n/(n - 1) E* g/(pi x).
    double slope_moment(double x, int k) const override;
    double centre_pressure(double x) const override;

  private:
    double coefficient_, exponent_;
};

/// k_n = g(x)/(c |x|^n) of the power law: n sqrt(pi)/2 Gamma(n/2)/Gamma((n+1)/2); 2 for a
/// paraboloid, pi/2 for a cone. Popov and Hess (2015), eq. 3.31. `n` >= 1, else std::domain_error.
double power_law_factor(double n);

/// Flat cylindrical punch whose edge is rounded: h = 0 up to the flat radius b, (r - b)^2/(2 R)
/// beyond. Schubert (1942); Ciavarella (1999), J. Strain Anal. 34.
class RoundedPunch final : public AxisymmetricIndenter {
  public:
    /// `flat_radius` b, `radius` R > 0 [m]; InputError otherwise.
    RoundedPunch(double flat_radius, double radius);
    double flat_radius() const { return flat_radius_; }
    double radius() const { return radius_; }
    double profile(double r) const override;
    double profile_slope(double r) const override;
    double outer_radius() const override;
    std::vector<double> kinks() const override { return {flat_radius_}; }
    bool presses_like_a_ball() const override { return false; }
    /// g = x/R [sqrt(x^2 - b^2) - b acos(b/x)].
    double slope_moment(double x, int k) const override;

  private:
    double flat_radius_, radius_;
};

}  // namespace tricontact::contact

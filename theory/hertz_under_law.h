#pragma once

#include "contact/case.h"

namespace tricontact::theory {

/// Hertz' contact under one force F_T along the surface, applied once, where a point carries
/// tau = min(tau_0 + mu p_r (p/p_r)^n, tau_cap): theory/rolling/bed_under_law.h in closed form, for
/// p = p_0 y, y^2 = 1 - r^2/a^2. With Y^2 = 1 - x^2/a^2 the springs carry (Jaeger 1995)
///   b(Y) = 2a [tau_0 Y + K C Y^(n+1)],  K = mu p_r (p_0/p_r)^n,  C = ∫_0^(pi/2) sin^(n+1),
/// without tau_cap; they stick inside x = c, where U G* = b(c), F_T = 2 [c b(c) + ∫_c^a b dx].
/// Coulomb's law gives Cattaneo and Mindlin.
class HertzUnderLaw {
  public:
    /// Radius a [m], p_0 [Pa] at the centre, G* of the pair [Pa].
    HertzUnderLaw(const contact::Friction& friction, double contact_radius, double peak_pressure,
                  double effective_shear_modulus);
    /// Of a sphere or paraboloid on a half-space, under its normal force or depth.
    explicit HertzUnderLaw(const contact::Case& c);

    // Over the bound of the middle, b(0), and a: at the edge of stick x = a sqrt(1 - Y^2), Y =
    // sin(angle), angle in [0, pi/2],

    /// b,
    double bound_ratio(double angle) const;
    /// and the force that lets all beyond slip.
    double force_ratio(double angle) const;

    /// Force at which all slides [N].
    double friction_limit() const;
    /// U at that force [m].
    double unit_shift() const;
    /// U [m] of F_T >= 0 [N]. Throws contact::InputError above the limit.
    double shift(double force) const;

  private:
    double bound(double root) const;         // b/(2a) at Y [Pa]
    double force(double angle) const;        // at Y = sin(angle) of the edge of stick [N]
    double cut_off(double angle) const;      // what tau_cap takes from ∫ b dx/(2a^2) up to there
    double excess_bound(double root) const;  // what it takes from b/(2a) [Pa]

    double radius_, shear_modulus_;
    double strength_, exponent_, rising_;  // tau_0, n, K
    double cap_, capped_from_;             // tau_cap; y beyond which it holds, 1: nowhere
    double chord_;                         // C
};

}  // namespace tricontact::theory

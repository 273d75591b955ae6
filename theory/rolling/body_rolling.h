#pragma once

#include <memory>
#include <optional>

#include "contact/bodies/indenter.h"
#include "contact/case.h"

namespace tricontact::theory {

// Pressure under bodies of revolution on a half-space without friction over its mean F_N/(pi a^2),
// at rho = r/a in [0, 1]: (1/pi) E* ∫_r^a g'(x)/sqrt(x^2 - r^2) dx with x^2 = r^2 + s^2, by double
// exponential quadrature to 1e-10; zero beyond. Each throws std::domain_error for arguments out of
// range.

/// Of h = c r^n, n >= 1: (n + 1)/2 ∫ (rho^2 + s^2)^((n - 2)/2) ds up to sqrt(1 - rho^2); Galin
/// (1946), Sneddon (1965). Falls with r for n <= 2, has a ring of largest pressure for n > 2.
/// Infinite at rho = 0 for n = 1.
double power_law_pressure(double exponent, double rho);

/// Of a rounded punch whose flat part has the radius `flat_ratio` = b/a in (0, 1); Schubert (1942),
/// Ciavarella (1999), whose g' is [2 sqrt(x^2 - b^2) - b acos(b/x)]/R. Largest beside the edge.
double rounded_punch_pressure(double flat_ratio, double rho);

// Friction and oscillating rolling of the case's body on a half-space under constant loads, normal
// and tangential contact uncoupled; what oscillating_rolling.h says of paraboloid and sphere, for
// all bodies whose pressure is known; under another law of friction see bed_under_law.h, f being
// F_T/F_lim. Dimensionless: f = F_T/(mu F_N), w = W/a over the contact
// radius of contact::half_space_scales, u = U/U_max, all in [0, 1], else std::domain_error.

/// Whether what follows knows the case's body: a smooth one, not a cylinder, roller or rough;
/// under another law than Coulomb's one of revolution whose pressure falls with r.
bool has_body_theory(const contact::Case& c);

/// The theory of a case's body, which stays with the caller. Built once for several questions: what
/// it rests on, but for round bodies, are tables.
class BodyRolling {
  public:
    /// Of a case that has_body_theory.
    explicit BodyRolling(const contact::Case& c);
    ~BodyRolling();

    /// Shift under F_T applied once, 1 - d((1-f) F_N)/d(F_N): the traction is mu p less that of the
    /// smaller load whose contact is the stick zone. Jaeger (1995), Ciavarella (1998); of ellipses
    /// Vermeulen and Johnson (1964). Neglects a transverse traction as Cattaneo and Mindlin do.
    double static_shift_ratio(double f) const;

    /// Largest f that shakes down: (1/F_N) ∫ min p dA over the path of the case's direction. Where
    /// the pressure falls with r it is that of the bed; where it does not (power laws of n > 2,
    /// punches), the middle of the path counts too: quadrature to 1e-4. Of ellipses that of a
    /// paraboloid, W over their half axis in the direction of rolling. Empty for the profile of a
    /// table.
    std::optional<double> shakedown_limit(double w) const;
    /// Its inverse, the largest w that shakes down; along the longer axis of an ellipse it may
    /// exceed 1.
    std::optional<double> amplitude_limit(double f) const;

    /// The method of dimensionality reduction (MDR), P(x) being the force and g(x) the indentation
    /// at which the contact has the radius x; bodies of revolution only. Shift of the bed after
    /// shakedown; the stick zone has the radius x - W, where u = 1 - g(x)/d and
    ///   f = 1 - P(x)/F_N - 2 E* W d u/F_N;
    /// of h ~ r^n: f = 1 - (1 - u)^((n+1)/n) - (n + 1)/n w u. Empty above the limit, that of x = W.
    std::optional<double> bed_settled_shift_ratio(double w, double f) const;

  private:
    struct Parts;
    std::unique_ptr<const Parts> parts_;
};

// One question each.
double static_shift_ratio(const contact::Case& c, double f);
std::optional<double> shakedown_limit(const contact::Case& c, double w);
std::optional<double> amplitude_limit(const contact::Case& c, double f);
std::optional<double> bed_settled_shift_ratio(const contact::Case& c, double w, double f);

}  // namespace tricontact::theory

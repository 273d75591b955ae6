#pragma once

#include "contact/bodies/indenter.h"

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

}  // namespace tricontact::theory

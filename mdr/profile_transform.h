#pragma once

#include "contact/indenter.h"

namespace tricontact::mdr {

// The plane profile that the method of dimensionality reduction presses into its springs,
//   g(x) = |x| ∫_0^|x| h'(r)/sqrt(x^2 - r^2) dr = |x| ∫_0^(pi/2) h'(|x| sin t) dt,
// Popov and Hess (2015), Method of Dimensionality Reduction, eq. 3.27; the second form, with
// r = x sin t, has no singularity left.

/// g(x)/(c |x|^n) of the power law h = c r^n: n sqrt(pi)/2 Gamma(n/2)/Gamma((n+1)/2); 2 for a
/// paraboloid, pi/2 for a cone. Popov and Hess (2015), eq. 3.31.
/// `n` >= 1, else std::domain_error.
double power_law_factor(double n);

/// g(x)/|x| [-] at x [m], |x| <= outer radius of the indenter, by adaptive Gauss-Kronrod
/// quadrature to 1e-13 relative; 1e-11 where h' jumps, since bisection closes in on a kink only so
/// far. Throws std::domain_error beyond the outer radius and contact::NotConverged when the
/// estimated error exceeds 1e-10.
double transformed_mean_slope(const contact::AxisymmetricIndenter& indenter, double x);

/// g(x) [m]; see `transformed_mean_slope`.
double transformed_profile(const contact::AxisymmetricIndenter& indenter, double x);

}  // namespace tricontact::mdr

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

/// g(x)/|x| [-] at x [m], |x| <= outer radius of the indenter, by double exponential quadrature
/// between the kinks: 1e-12 relative, unless h' itself is ill-conditioned (near a vertical rim).
/// The slope must not be negative. Throws std::domain_error beyond the outer radius and
/// contact::InputError when the estimated error exceeds 1e-10: kinks that are not declared.
double transformed_mean_slope(const contact::AxisymmetricIndenter& indenter, double x);

/// g(x) [m]; see `transformed_mean_slope`.
double transformed_profile(const contact::AxisymmetricIndenter& indenter, double x);

}  // namespace tricontact::mdr

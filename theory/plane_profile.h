#pragma once

#include "contact/indenter.h"

namespace tricontact::theory {

/// g(x) [m] at 0 <= x <= outer radius [m]: the plane profile of the method of dimensionality
/// reduction,
///   g(x) = x ∫_0^x h'(r)/sqrt(x^2 - r^2) dr = x ∫_0^(pi/2) h'(x sin t) dt,
/// Popov and Hess (2015), eq. 3.27, by double exponential quadrature between the kinks.
double plane_profile(const contact::AxisymmetricIndenter& indenter, double x);

}  // namespace tricontact::theory

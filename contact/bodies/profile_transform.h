#pragma once

#include "contact/bodies/indenter.h"

namespace tricontact::contact {

// Integrals over the slope h' of a body of revolution by double exponential quadrature between its
// kinks, r = x sin t taking away the singularity at r = x: 1e-12 relative, unless h' itself is
// ill-conditioned (near a vertical rim). The slope must not be negative; 0 < x <= outer radius.
// They throw std::domain_error for another x and InputError where the estimated error exceeds
// 1e-10: kinks that are not declared.

/// ∫_0^x h'(r) r^k/sqrt(x^2 - r^2) dr [m^k].
double transformed_slope_moment(const AxisymmetricIndenter& indenter, double x, int k);

/// 1/pi ∫_0^x h'(r) [1/sqrt(x^2 - r^2) + acos(r/x)/r] dr [-], which is 1/pi ∫_0^x g'(s)/s ds with
/// the order of integration changed; infinite for h'(0) > 0.
double transformed_centre_pressure(const AxisymmetricIndenter& indenter, double x);

}  // namespace tricontact::contact

#pragma once

#include "contact/case.h"

namespace tricontact::theory {

// Hertz' frictionless contact of a paraboloid with a half-space; the scales a, d, F_N and p0 of a
// case come from contact::hertz_scales. Axisymmetric, r is the distance from the axis.
// Every function throws std::domain_error for a negative or NaN argument.

/// Pressure p(r) [Pa] at r >= 0 [m], compression positive; zero outside the contact.
/// Johnson (1985), Contact Mechanics, eq. 3.39: p = p0 sqrt(1 - r^2/a^2).
double hertz_pressure(const contact::HertzScales& scales, double r);

/// Displacement u_z(r) [m] of the half-space's surface at r >= 0 [m], into the body positive, far
/// field zero. Johnson (1985), eq. 3.41a and 3.42a; for a rigid indenter, or the sum of both
/// bodies.
double hertz_surface_displacement(const contact::HertzScales& scales, double r);

}  // namespace tricontact::theory

#pragma once

#include "contact/case.h"

namespace tricontact::theory {

// Hertz' frictionless contact of a paraboloid with a half-space; the scales a, d, F_N and p0 of a
// case come from contact::half_space_scales. Axisymmetric, r is the distance from the axis.
// Every function throws std::domain_error for a negative or NaN argument.

/// Pressure p(r) [Pa] at r >= 0 [m], compression positive; zero outside the contact.
/// Johnson (1985), Contact Mechanics, eq. 3.39: p = p0 sqrt(1 - r^2/a^2).
double hertz_pressure(const contact::HalfSpaceScales& scales, double r);

/// Displacement u_z(r) [m] of the half-space's surface at r >= 0 [m], into the body positive, far
/// field zero. Johnson (1985), eq. 3.41a and 3.42a; for a rigid indenter, or the sum of both
/// bodies.
double hertz_surface_displacement(const contact::HalfSpaceScales& scales, double r);

// What an evaluation by Hertz' theory finds for E* [Pa] of a half-space from the force F [N], the
// radius R [m] of the indenter and one more quantity; all > 0. Johnson (1985), ch. 4.

/// From the indentation d [m]: F = 4/3 E* sqrt(R) d^(3/2).
double hertz_modulus_from_indentation(double force, double radius, double indentation);
/// From the contact radius a [m]: a^3 = 3 F R/(4 E*).
double hertz_modulus_from_contact_radius(double force, double radius, double contact_radius);

}  // namespace tricontact::theory

#pragma once

#include "contact/case.h"

namespace tricontact::contact {

/// Hertz' contact of a paraboloid of the radius [m] under F_N [N]: its scales.
HalfSpaceScales hertz_scales(const MaterialPair& materials, double radius, double normal_force,
                             double coulomb_coefficient);

/// Half width a [m] of the contact of a cylinder of the radius R [m] with a half-space under the
/// load F/L [N/m]: a^2 = 4 (F/L) R/(pi E*); Johnson (1985), eq. 4.43.
double line_half_width(double load, double radius, double effective_modulus);

/// lambda = 1/2 + ln 2 + ln(L/a) + q [-], q = sum(nu/G) / sum((1 - nu)/G) over both bodies, which
/// is nu/(1 - nu) for one: `length_ratio` is L/a.
double line_shift_factor(const MaterialPair& materials, double length_ratio);

/// The same of a case of a line contact, of its own L and a.
double line_shift_factor(const Case& c);

/// The shape has no curvature of its own: what a case says of a radius means nothing.
bool is_nominally_flat(const Case& c);

/// Nominal area of a nominally flat contact: the square of the period, or the map's [m^2].
double nominal_area(const Case& c);

}  // namespace tricontact::contact

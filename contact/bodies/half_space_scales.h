#pragma once

#include "contact/case.h"

namespace tricontact::contact {

/// Half width a [m] of the contact of a cylinder of the radius R [m] with a half-space under the
/// load F/L [N/m]: a^2 = 4 (F/L) R/(pi E*); Johnson (1985), eq. 4.43.
double line_half_width(double load, double radius, double effective_modulus);

/// Scales of a cylinder of the length L on the half-space, long beside its contact, by Hertz:
///   a as above, p0 = 2 F_N/(pi a L),
/// and by the displacement of the centre under pressure and traction that are uniform along L:
///   d = 2 F_N/(pi E* L) (1/2 + ln 2 + ln(L/a)),
///   U_max = mu 2 F_N/(pi E* L) lambda,  lambda = line_shift_factor() as below;
/// relative errors of (a/L)^2. The thesis' (3.5.2),
/// (3.5.3); its U_0 (3.5.12) has a fitted ln(1.8 E*/G*) instead of q: right for nu = 1/2 (0.993
/// beside 1), too much by 0.59 for nu = 0.
/// A prescribed d must be below that of a = L/10. Throws InputError.
HalfSpaceScales line_contact_scales(const Case& c);

/// lambda = 1/2 + ln 2 + ln(L/a) + q [-], q = sum(nu/G) / sum((1 - nu)/G) over both bodies, which
/// is nu/(1 - nu) for one: `length_ratio` is L/a.
double line_shift_factor(const MaterialPair& materials, double length_ratio);

/// The shape has no curvature of its own: what a case says of a radius means nothing.
bool is_nominally_flat(const Case& c);

/// Nominal area of a nominally flat contact: the square of the period, or the map's [m^2].
double nominal_area(const Case& c);

/// Scales of a nominally flat contact, which Hertz' solution has not: the radius of a circle of the
/// nominal area; the rms height of the surface; p0 = E* h'/2, h' its rms slope, which is the rms
/// pressure of full contact (Johnson 1985, eq. 13.7) and about the mean one of light contact; F_N
/// as prescribed, or p0 on the nominal area where the indentation is.
HalfSpaceScales rough_scales(const Case& c);

}  // namespace tricontact::contact

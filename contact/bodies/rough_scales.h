#pragma once

#include "contact/case.h"

namespace tricontact::contact {

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

#pragma once

namespace tricontact::theory {

/// Where fretting in partial slip ends: a paraboloid of the radius R, pressed to a depth d that
/// stays and moved back and forth along the surface so that the radius c sticks. The ring about it
/// wears until it carries nothing: the plane profile is g = x^2/R within c and d outside, so that
/// the body is
///   f(r) = 2/(pi R) [r^2/2 asin(c/r) - c/2 sqrt(r^2 - c^2)] + d (1 - 2/pi asin(c/r)),  r > c,
/// up to where it meets r^2/(2 R); Popov (2014). It is d less what the pressures of the disc c
/// displace the surface by. Lengths in m.
struct WornParaboloid {
    double radius = 0;        ///< R
    double depth = 0;         ///< d
    double stick_radius = 0;  ///< c, 0 < c^2 < R d

    /// c of a cycle between the shifts +-U_A, 0 where all slips: mu E*/G* (d - c^2/R) = U_A.
    /// `ratio`: mu E*/G*.
    static WornParaboloid of_cycle(double radius, double depth, double shift_amplitude,
                                   double ratio);
    /// f(r) of the worn body, r >= 0.
    double profile(double r) const;
    /// f(r) - r^2/(2 R), >= 0.
    double worn(double r) const;
};

}  // namespace tricontact::theory

#pragma once

#include <array>

#include "contact/substrates/material.h"

namespace tricontact::theory {

/// A cylinder pressed on a half-space in plane strain, without coupling of normal and tangential
/// contact, under a tangential force and a stress along x in all of the half-space that act
/// together: Nowell and Hills (1987). What sticks is |x - stick_centre| < stick_half_width, and the
/// traction on the half-space is
///   q = sgn(F_T) mu p0 [ sqrt(1 - (x/a)^2) - (c/a) sqrt(1 - ((x - e)/c)^2) ],
///   (c/a)^2 = 1 - |F_T|/(mu F_N),  e = sgn(F_T) eps E* a/(2 mu p0),
/// eps = (1 - nu^2) sigma/E the strain of the half-space: e = sigma a/(4 mu p0) of equal bodies.
struct BulkStressLine {
    double half_width = 0;                          ///< a [m]
    double peak_pressure = 0;                       ///< p0 [Pa]
    double friction = 0;                            ///< mu [-]
    double force_ratio = 0;                         ///< F_T/(mu F_N), -1 to 1 [-]
    double bulk_stress = 0;                         ///< sigma [Pa]
    double stick_half_width = 0, stick_centre = 0;  ///< c, e [m]

    /// The whole slides, or no point slips backward at an edge: else the solution is another one.
    bool holds() const;
    /// On the half-space [Pa].
    double traction(double x) const;
    /// Stresses at the depth z >= 0 [m], XX YY ZZ XY YZ XZ with z into the body [Pa].
    std::array<double, 6> stress(const contact::Material& material, double x, double z) const;
    /// XX at the edge of the contact that F_T on the half-space points away from, x = -sgn(F_T) a:
    /// where fretting cracks begin: sigma + 2 mu p0 [sqrt((a + e')^2 - c^2) - e']/a with e' =
    /// sgn(F_T) e; 2 mu p0 of sliding (Johnson 1985, section 7.1).
    double trailing_stress() const;
};

/// `effective_modulus`: E* [Pa]. `normal_load`: F_N per length [N/m]. `radius`: of the cylinder
/// [m].
BulkStressLine bulk_stress_line(double effective_modulus, const contact::Material& half_space,
                                double radius, double normal_load, double friction,
                                double force_ratio, double bulk_stress);

}  // namespace tricontact::theory

#pragma once

#include "benchmarks/reference/reference.h"

namespace tricontact::benchmarks {

/// A rigid flat punch of the radius 5 mm on a half-space, E = 5.2 MPa, nu = 0.3, under 20 N, which
/// press it in by 0.35 mm. Boussinesq (1885); Johnson (1985), section 3.8. `by_force`: which of
/// force and depth is prescribed. Its edge is singular.
Reference complete_punch_reference(bool by_force);

/// A rigid punch, flat within 5 mm to either side and rounded by R = 100 mm, on the half-space of
/// the same material in plane strain, pressed until a = 10 mm: 1.7548 N/mm. Ciavarella, Hills and
/// Monno (1998).
Reference rounded_punch_plane_reference();

/// A pin of 9.98 mm in a hole of 10 mm in an infinite plate of the same steel, plane strain,
/// pressed until the contact reaches to 30 degrees: 581.02 N/mm. x of its fields is that of the
/// surface, R sin(theta), p the pressure along its normal: ∫ p dx is the force. Persson (1964).
Reference pin_in_hole_reference();

/// Two blocks of E = 1 MPa, nu = 0, 1000 mm x 500 mm each, one on the other, compressed by a strain
/// of 0.1: a uniform pressure of 0.1 MPa, the interface moves by -50 mm, 100 N per mm of depth.
/// Taylor and Papadopoulos (1991).
Reference patch_test_reference();
/// Of the same, what a penalty K [Pa/m] changes of the pressure: 1/(1 + E/(K H)) - 1, H the height
/// of both.
double patch_test_penalty(double stiffness);

/// A block that slides up a slope of 0.1 with friction 0.3: F/G = (tan(alpha) + mu)/(1 - mu
/// tan(alpha)). NAFEMS CGS-4. There are no fields.
Reference wedge_reference();
inline constexpr double wedge_slope = .1, wedge_friction = .3;

}  // namespace tricontact::benchmarks

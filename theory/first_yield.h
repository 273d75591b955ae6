#pragma once

#include <array>
#include <functional>

#include "contact/substrates/material.h"
#include "theory/bulk_stress_line.h"

namespace tricontact::theory {

/// Where von Mises' stress sqrt(3 J2) is largest.
struct StressPeak {
    double von_mises = 0;  ///< [Pa]
    double x = 0;          ///< from the centre of the contact [m]
    double depth = 0;      ///< [m]; 0: at the surface
};

/// Below a line contact with or without tangential force and bulk stress.
StressPeak line_stress_peak(const BulkStressLine& line, const contact::Material& material);

/// Below a sphere's contact, in the plane of the tangential force: Hertz' pressure and the traction
/// of Cattaneo and Mindlin on the half-space, whose part across the force is left out.
/// `force_ratio`: F_T/(mu F_N), -1 to 1. What is nearer to the surface than `sphere_surface` a is
/// taken there, but for the edge of the contact, whose stresses are exact. `bulk_stress` [Pa]:
/// along x, in all of the body; `stick_centre` [m]: of the circle that sticks.
StressPeak sphere_stress_peak(const contact::Material& material, double contact_radius,
                              double peak_pressure, double friction, double force_ratio,
                              double bulk_stress = 0, double stick_centre = 0);
inline constexpr double sphere_surface = 1e-4;

/// Largest p0/k, k = yield_stress/sqrt(3), at which a material that does not harden shakes down
/// under a line contact that passes over it again and again, sliding with the friction mu: the
/// limit of Melan's theorem by von Mises' criterion, for residual stresses that depend on the depth
/// alone. Johnson (1985), section 9.2, takes the stress across as the middle one whatever passes,
/// which it is at nu = 1/2: 4 of rolling without traction, at the surface 1/mu from mu = .367 on.
/// At nu = .3 the surface decides from mu = .32 on, with .91/mu there and .96/mu at mu = 1.
double line_shakedown_pressure(double friction, double poisson);

}  // namespace tricontact::theory

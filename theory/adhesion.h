#pragma once

namespace tricontact::theory {

// Adhesion of a sphere of the radius R [m] on a half-space: work of adhesion w [J/m^2], E* [Pa].
// Every function throws std::domain_error unless R, E*, w and the distance are positive; forces are
// positive where they press.

/// Johnson, Kendall and Roberts (1971, Proc. R. Soc. A 324, 301): short-ranged adhesion of soft,
/// large spheres. Derjaguin, Muller and Toporov (1975, J. Colloid Interface Sci. 53, 314):
/// long-ranged adhesion of stiff, small ones.
enum class Adhesion { jkr, dmt };

/// The largest force that pulls it off [N]: 3/2 pi w R (JKR), 2 pi w R (DMT).
double pull_off_force(Adhesion theory, double radius, double work);

/// Contact radius a [m] under the force F [N] >= -pull_off_force, larger than Hertz':
/// a^3 = 3 R/(4 E*) (F + 3 pi w R + sqrt(6 pi w R F + (3 pi w R)^2)) (JKR),
/// a^3 = 3 R/(4 E*) (F + 2 pi w R) (DMT). Throws std::domain_error also for a force that pulls it
/// off.
double adhesive_contact_radius(Adhesion theory, double force, double radius, double modulus,
                               double work);

/// Tabor's parameter (R w^2/(E*^2 z0^3))^(1/3) [-] of the interatomic distance z0 [m] (Tabor 1977,
/// J. Colloid Interface Sci. 58, 2): JKR above some 5, DMT below some 0.1 (Johnson and Greenwood
/// 1997).
double tabor_parameter(double radius, double work, double modulus, double distance);

}  // namespace tricontact::theory

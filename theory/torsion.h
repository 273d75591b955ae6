#pragma once

namespace tricontact::theory {

// Lubkin (1951), The torsion of elastic spheres in contact, J. Appl. Mech. 18, 183: a Hertzian
// contact under constant normal force, then a twist about the normal, small enough that what slips
// is an annulus c < r < a. Exact on half-spaces: circumferential tractions displace nothing else.
// Dimensionless: stick radius over a; torque over mu F_N a; twist over mu F_N/(G a^2), G the shear
// modulus of the substrate under a rigid indenter (of two bodies 1/G is the sum of both 1/G).
// Every function throws std::domain_error outside of its range.

/// Twist that leaves a stick zone of the radius c/a in (0, 1]: 3/(4 pi) [K(k) - E(k)], complete
/// elliptic integrals of the modulus k = sqrt(1 - c^2/a^2). Infinite slip at c = 0.
double twist_ratio(double stick_radius_ratio);

/// Torque at this twist: 3 pi/16 at c = 0, all slips; (16/3) twist as c -> 1, all sticks (Reissner
/// and Sagoci 1944). From the torsion phi(s) of punches s < r that add up to the traction,
/// M = (16/3) G int_c^a s^3 dphi(s).
double torque_ratio(double stick_radius_ratio);

}  // namespace tricontact::theory

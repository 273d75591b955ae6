#pragma once

namespace tricontact::theory {

/// Exponent lambda - 1 in (-1/2, 0] with which the pressure p ~ y^(lambda - 1) under a sharp edge
/// of `wedge_angle` phi [rad] in (0, pi) on an elastic half-plane grows towards the edge, y -> 0;
/// frictionless, plane strain. lambda is the root in [1/2, 1] of
///   (1 + alpha) cos(pi lambda) [sin^2(lambda phi) - lambda^2 sin^2 phi]
///     + 1/2 (1 - alpha) sin(pi lambda) [sin(2 lambda phi) + lambda sin(2 phi)] = 0
/// (Dundurs and Lee 1972, J. Elasticity 2), which follows from Williams' (1952) eigenfunctions.
/// `dundurs_alpha`: (E1' - E2')/(E1' + E2') in [-1, 1], E' = E/(1 - nu^2), body 1 the wedge:
/// 1 for a rigid wedge (square root for every angle), -1 for a rigid half-plane.
/// Throws std::domain_error out of these ranges.
double edge_pressure_exponent(double wedge_angle, double dundurs_alpha);

}  // namespace tricontact::theory

#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "contact/substrates/material.h"

namespace tricontact::theory {

// Inside an elastic half-space under tractions on its surface; z into the body, pressure p > 0
// pressing, tangential traction acting on the half-space.
//
// All fields follow from harmonic functions of the load. With rho = sqrt(x^2 + y^2 + z^2),
//   L = ln(rho + z),  M = z ln(rho + z) - rho  (so that M_z = L, L_z = 1/rho),
// a point force P along z makes
//   4 pi G u_i = P [-z L_iz - (1 - 2 nu) L_i],   4 pi G u_z = P [-z L_zz + 2 (1 - nu) L_z],
// and Q along j = x, y
//   4 pi G u_i = Q [2 delta_ij L_z - z L_ij + 2 nu M_ij],  4 pi G u_z = Q [-z L_jz + (1 - 2 nu)
//   L_j].
// Boussinesq (1885), Cerruti (1882); Love (1929) for areas; Johnson (1985), sections 3.2 and 3.6.
// Divergences are 2 (1 - 2 nu) times a derivative of L: stresses need no special case at nu = 1/2.

/// Derivatives of L and M, integrated over a load or combined linearly in any other way. The
/// harmonic ones with two or three z are left out where the others give them.
enum HarmonicDerivative : std::size_t {
    L_x,
    L_y,
    L_z,
    L_xx,
    L_xy,
    L_yy,
    L_xz,
    L_yz,
    L_xxx,
    L_xxy,
    L_xyy,
    L_yyy,
    L_xxz,
    L_xyz,
    L_yyz,
    M_xx,
    M_xy,
    M_yy,
    M_xxx,
    M_xxy,
    M_xyy,
    M_yyy,
    n_harmonic_derivatives
};
using HarmonicDerivatives = std::array<double, n_harmonic_derivatives>;

/// Response at a point inside to a load in each direction: [component][direction of the load], the
/// directions being x, y and pressing. Per traction [m/Pa] and [-] or per force [m/N] and [1/m^2],
/// as the derivatives were integrated.
struct InteriorResponse {
    std::array<std::array<double, 3>, 3> displacement{};  ///< x, y, z into the body
    std::array<std::array<double, 3>, 6> stress{};        ///< XX YY ZZ XY YZ XZ
};

/// Response at the depth z >= 0 [m].
InteriorResponse half_space_response(const contact::Material& material, double depth,
                                     const HarmonicDerivatives& derivatives);

/// Displacements and stresses inside a half-space at (x, y, z), z > 0 into the body [m], under an
/// axisymmetric pressure around the origin, or under a tangential traction of the same
/// distribution: [component][load along x, y, pressing], in [m] and [Pa].
///
/// `line_load`: the even q(t) [N/m], |t| <= `radius` [m], that MDR gives the pressure (of Hertz'
/// contact E* (d - t^2/R)); the potential of the pressure is
///   ∫ p/rho dA = ∫_-a^a q(t)/sqrt(r^2 + (z + i t)^2) dt,
/// point forces at complex depths, and so are all other fields (Green and Zerna 1954 on discs;
/// Popov and Hess 2015 on the line load). Gauss and Kronrod's rule, to 1e-9
/// from z = 1e-4 a on; closer to the surface the integrand is too steep for it.
/// Sliding bodies of revolution with the friction mu: the response to x times mu, that to pressing
/// added. Exact for Hertz' sphere: Huber (1904), Hamilton and Goodman (1966).
InteriorResponse axisymmetric_interior(const contact::Material& material,
                                       const std::function<double(double t)>& line_load,
                                       double radius, double x, double y, double z);

}  // namespace tricontact::theory

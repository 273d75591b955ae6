#pragma once

#include <functional>

#include "theory/half_space_interior.h"

namespace tricontact::theory {

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

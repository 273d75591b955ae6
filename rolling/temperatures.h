#pragma once

#include <vector>

#include "contact/heat.h"
#include "contact/surface.h"
#include "rolling/rolling_contact.h"

namespace tricontact::rolling {

/// Temperatures of both surfaces in steady rolling at `speed` [m/s], after Ertz and Knothe (2002):
/// the bodies touch without thermal resistance, their material passes at one speed, and heat flows
/// into the depth alone (fast rolling, Pe >> 1; row by row). So heat of friction q = |t| v_s is
/// shared as their effusivities, b_2/(b_1 + b_2) of it into the substrate, and both surfaces are as
/// warm:
///   T = T_m + 1/((b_1 + b_2) (pi v)^(1/2)) int q(s) (s - x)^(-1/2) ds, x < s ahead,
/// T_m that of bodies of two temperatures that touch. The integral is exact for a q that is
/// constant on cells, taken at their centres: of order 3/2 in the cell where q is smooth. Behind
/// the contact no heat leaves; what conduction brought goes on as arcsin, as it does of a surface
/// at constant temperature.
///
/// `surface`: on a grid, its dissipation per rolled way, which goes to +x; a row is in contact from
/// its first point under pressure to its last.
SurfaceTemperatures surface_temperatures(const contact::Surface& surface,
                                         const contact::ContactHeat& heat, double speed);

/// By how much friction alone heats both surfaces [K], the integral above.
std::vector<double> friction_heating(const contact::Surface& surface,
                                     const contact::ContactHeat& heat, double speed);

/// Highest in contact.
HighestTemperature highest_temperature(const contact::Surface& surface,
                                       const SurfaceTemperatures& temperatures);

}  // namespace tricontact::rolling

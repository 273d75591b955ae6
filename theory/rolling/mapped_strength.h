#pragma once

#include <optional>

#include "theory/rolling/mapped_shakedown.h"

namespace tricontact::theory {

// Settled shift of a paraboloid that rolls back and forth on an uncoupled half-space whose
// interface carries a shear strength tau_0 under any pressure: mapped_shakedown.h for that law of
// friction,
//   f = (2/pi) [arcsin u + u sqrt(1 - u^2)] - kappa w u,  f = F_T/(pi tau_0 a^2),
// kappa = 4/pi of MDR. In three dimensions, n as there:
//   w -> 0:         `small_amplitude_strength_mapping`, at any u;
//   f -> 0:         the flat punch of the common contact, `small_load_mapping` at nu = 0;
//   f = f_T,lim:    tau_0 on the lens, and the shift is that of its centre.
// The limit itself is exact, f_T,lim = (2/pi) [arccos w - w sqrt(1 - w^2)], the lens' area.
// MappedRolling::tangential_ratio is f.

/// kappa for w -> 0 at a fixed u in [0, 1]: (8/pi^2) [arcsin u - n u sqrt(1 - u^2)]/u. Rolling
/// takes tau_0 from a rim of the width w a |cos(phi)|; what the force loses at the same shift is,
/// by reciprocity, the rim's load times its slip while the stick zone, a flat punch of the radius
/// c = a sqrt(1 - u^2), moves by one: 1 - (2/pi) [arcsin(c/a) + 3 n' (c/a) sqrt(1 - c^2/a^2)],
/// 3 n' = nu/(2 - nu) cos(2 theta) at the rim's angle theta to the load. From (8/pi^2)(1 - n) to
/// MDR's 4/pi; exact but for the traction across the load. The point's w and f are not used.
double small_amplitude_strength_mapping(const MappedRolling& point, double u);

/// u_sd at f = f_T,lim, exact: the shift at the centre of the lens under tau_0,
/// (2/pi) ∫_0^pi/2 [sqrt(1 - w^2 sin^2) - w cos] [1 + nu/(2 - nu) cos(2 phi) cos(2 angle)] dphi.
/// For small w 1 - (2/pi)(1 + n) w; MDR's is sqrt(1 - w^2). The point's load is not used.
double largest_strength_shift_ratio(const MappedRolling& point);

/// kappa = k_0 + (k_1 - k_0) {1 - (1 - phi^2)^(0.18 + 0.36 sqrt(w))}, phi = f/f_T,lim, between
/// those of small loads, k_0 = small_load_mapping (1 - n sqrt(1 - w)), and of the limit, k_1,
/// exact.
double strength_mapping(const MappedRolling& point);

/// u_sd by `strength_mapping`, u_stat at w = 0; empty beyond the limit (ratcheting).
std::optional<double> strength_settled_shift_ratio(const MappedRolling& point);

}  // namespace tricontact::theory

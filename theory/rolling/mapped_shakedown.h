#pragma once

#include <optional>

#include "theory/rolling/rolled_law.h"

namespace tricontact::theory {

// Settled shift of a paraboloid that rolls back and forth on an uncoupled half-space, by the mapped
// formula of the method of dimensionality reduction (MDR),
//   f = 1 - kappa w u - (1 - u)^(3/2),
// with a kappa that has the limits of the three-dimensional contact. n says what angle and
// Poisson's ratio do:
//   n = nu cos(2 angle)/(3 (2 - nu)).
//   w -> 0, f -> 0: kappa = (3/pi)(1 - n), exact: what slips is thin, and the stick zone acts as a
//                   flat punch that loses a rim of the width W |cos(phi)|, 2/pi W in the mean;
//   w -> 0:         `small_amplitude_mapping`, exact with Cattaneo's and Mindlin's traction, 3/2 at
//                   f = 1;
//   f -> 0:         u_sd/u_stat is the compliance of a flat punch of the shape of the common
//                   contact, the lens inside all discs of the path, over that of the whole disc;
//   f = f_T,lim:    all points carry the least bound of their path, and the shift follows by one
//                   integral: `largest_settled_shift_ratio`.
// The limit itself is exact, f_T,lim = 1 - 3/2 w + 1/2 w^3.

/// A point of the map. Functions throw std::domain_error out of these ranges.
struct MappedRolling {
    double amplitude_ratio = 0;   ///< w = W/a in [0, 0.85]
    double tangential_ratio = 0;  ///< f = F_T/(mu F_N) in [0, 1]
    double angle = 0;             ///< between load and rolling [rad], any
    double poisson = 0;           ///< of both bodies together, in [0, 1/2]
};

/// Throws std::domain_error that names what is out of its range.
void check(const MappedRolling& point);
/// nu/(2 - nu) cos(2 angle) = 3 n.
double orientation(const MappedRolling& point);

/// kappa = 3/2 - [3/2 - (3/pi)(1 - n)] (1 - w)^0.42 [1 - phi (1 - 0.06 w)]^(0.19 + 0.05 w),
/// phi = f/f_T,lim; the same at phi = 1 for larger loads. Its u_sd differs from the atlas of
/// boundary elements (w >= 0.02, 0.02 <= phi <= 0.99) by 1.3 % at most, 0.17 % in the median; kappa
/// by 7.1 % and 0.3 %. At phi = 1 u_sd is up to 3.4 % too low.
double half_space_mapping(const MappedRolling& point);

/// For the back of an envelope: 3/2 - [3/2 - (3/pi)(1 - n)] (1 - w)^0.43 (1 - phi)^0.18. u_sd
/// within 1.9 % for phi <= 0.9, 0.17 % in the median; towards phi = 1 it tends to MDR's, too high.
double simple_half_space_mapping(const MappedRolling& point);

/// u_sd = U_sd/U_max in [0, 1 - w^2] by `half_space_mapping`; empty beyond the limit (ratcheting).
/// At w = 0 u_stat = 1 - (1 - f)^(2/3).
std::optional<double> half_space_settled_shift_ratio(const MappedRolling& point);

/// kappa for w -> 0 at a fixed load. With c = (1 - f)^(1/3), K and E of the modulus sqrt(1 - c^2):
/// kappa = 12/pi^2 { ∫_c^1 E(sqrt(1 - s^2)) ds - n c [E - c^2 K] }/(1 - c^2).
/// By reciprocity with the flat punch of the radius of the stick zone: rolling takes
/// w |cos(phi)| |dp/dr| from the bound outside of it. Exact but for the transverse traction that
/// Cattaneo and Mindlin neglect. The point's amplitude is not used.
double small_amplitude_mapping(const MappedRolling& point);

/// kappa for f -> 0 at nu = 0 or over the mean of the angles: kappa_MDR (1 - a_c/a)/w with a_c the
/// radius of a round punch of the compliance of the common contact, for w in (0, 1); that of
/// Coulomb's law unless told. The lens is replaced by the ellipse of its area and aspect ratio,
/// whose a_c is the arithmetic-geometric mean of its semi-axes.
double small_load_mapping(double w, const RolledLaw& law = coulomb_rolling);

/// u_sd at f = f_T,lim, exact: the shift at the centre under the least traction of each point's
/// path,
/// (4/pi^2) ∫_0^pi/2 {(1 - w^2 sin^2) arccos[w cos/sqrt(1 - w^2 sin^2)] - w cos sqrt(1 - w^2)}
///          [1 + nu/(2 - nu) cos(2 phi) cos(2 angle)] dphi.
/// For small w 1 - (8/pi^2)(1 + n) w; MDR's is 1 - w^2. The point's load is not used.
double largest_settled_shift_ratio(const MappedRolling& point);

}  // namespace tricontact::theory

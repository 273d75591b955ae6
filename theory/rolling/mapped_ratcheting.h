#pragma once

#include "theory/rolling/mapped_shakedown.h"

namespace tricontact::theory {

// Ratcheting of a paraboloid that rolls back and forth on an uncoupled half-space: the shift of
// each period once it is steady, Delta u = eta (w - w_lim) over U_max. With Cattaneo's stick radius
// s = (1 - f)^(1/3), w_lim the amplitude at which f is the limit of shakedown, and o = nu cos(2
// angle)/(2 - nu),
//   eta = 4 (1 - s) (1 - o/2 - o^2/8)/[0.98 - 0.964 w_lim + 1.4 exp(-8.8 w) (w_lim/w)^2].
// 1 - s is the law of the creepage of steady rolling (Vermeulen and Johnson, J. Appl. Mech. 31
// (1964) 338), to which each way between turning points comes near where f is large; the other
// numbers are fitted to the atlas sphere_half_space_ratcheting. Range: w in [0, 0.85], f above the
// limit; the atlas begins at w = 0.1 and ends at 0.95 of the way from the limit to 1. There the
// formula is off by 9.5 % at most, 1.6 % in the median.

/// eta; std::domain_error at or below the limit, and out of range.
double half_space_ratcheting_slope(const MappedRolling& point);

/// Delta u; 0 at or below the limit.
double half_space_shift_increment_ratio(const MappedRolling& point);

// The same of a cylinder, s = sqrt(1 - f) its half width of stick and w_lim that of the line
// contact:
//   lambda eta = 8 (1 - s)/[1 - 1.02 w_lim^1.44 + 1.55 exp(-8.3 w) (w_lim/w)^3],
// with Carter's creepage in the numerator, line_steady_slope(), to which it tends at f = 1; the
// others are fitted to the atlas cylinder_half_space_ratcheting. Same range; off by 8 % at most,
// 2.1 % in the median.

/// lambda eta; std::domain_error at or below the limit, and out of range.
double line_ratcheting_slope(double w, double f);

/// Delta u; 0 at or below the limit. lambda > 0: contact::line_shift_factor().
double line_shift_increment_ratio(double w, double f, double lambda);

}  // namespace tricontact::theory

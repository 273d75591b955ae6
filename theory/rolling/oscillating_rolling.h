#pragma once

#include <optional>

namespace tricontact::theory {

// Oscillating rolling of a paraboloid under constant normal and tangential force, in the reading
// of the method of dimensionality reduction (MDR). Wetter and Popov (2014), Int. J. Solids Struct.
// 51; the equation numbers are those of Wetter's thesis (TU Berlin). Dimensionless:
//   w = W/a in [0, 1]          rolling amplitude over the contact radius,
//   f = F_T/(mu F_N) in [0, 1] tangential force over the friction limit,
//   u = U/U_max in [0, 1]      rigid shift over U_max = mu (E*/G*) d,
//   kappa in (0, 3/2]          mapping parameter, 3/2 for MDR itself. Above 3/2 the force would
//                              not grow with the shift up to the limit: out of range.
// Every function throws std::domain_error for an argument out of these ranges.

inline constexpr double mdr_mapping = 1.5;                   ///< exact for MDR
inline constexpr double thesis_mapping_parallel = 1.0;       ///< fit, load along the rolling
inline constexpr double thesis_mapping_perpendicular = 1.1;  ///< fit, load across the rolling

/// Force that shifts by u in [0, 1] when applied once, 1 - (1 - u)^(3/2).
double static_force_ratio(double u);

/// Shift u_sd after shakedown, solving f = 1 - kappa w u - (1 - u)^(3/2) (3.2.15, 3.2.16) in
/// [0, 1 - w^2]; empty if f exceeds the limit (ratcheting).
std::optional<double> settled_shift_ratio(double w, double f, double kappa = mdr_mapping);

/// kappa that maps a measured settled shift: (1 - f - (1 - u)^(3/2))/(w u), for w, u > 0 (3.2.16).
/// Ill-conditioned where w u is small: an error of f divides by w u. The result may lie anywhere.
double mapping_parameter(double w, double f, double u);

/// Largest f that shakes down: 1 - kappa w (1 - w^2) - w^3 (stick zone just vanished, 3.2.17);
/// kappa = 3/2: 1 - 3/2 w + 1/2 w^3, which is also the exact limit of every uncoupled contact.
double shakedown_limit(double w, double kappa = mdr_mapping);

/// Largest w that shakes down, the inverse of `shakedown_limit`.
double amplitude_limit(double f, double kappa = mdr_mapping);

/// Slope d(Du)/dw [-] of MDR's shift increment per period just beyond the limit w_l =
/// amplitude_limit(f): eta_0 = 4 (1 - w_l^2)/(1 + w_l - w_l^2 + w_l^3/3).
double mdr_threshold_slope(double f);

/// Thesis' fits of the shift increment per period beyond the limit, in units of U_max:
/// sqrt(2 u_stat) (w - w_lim) along the rolling (3.3.4), sqrt(5 u_stat) (w - w_lim) across
/// (3.4.15), with u_stat = 1 - (1 - f)^(2/3) and the thesis' own limit (kappa = 1 and 1.1). Zero
/// below it.
double thesis_increment_parallel(double w, double f);
double thesis_increment_perpendicular(double w, double f);

/// Zones of MDR after shakedown, the roller upright; radii over a.
struct ShakedownZones {
    double stick;  ///< c_sd = sqrt(1 - u) - w: stick inside
    double slip;   ///< b = 1 - w: slipped from c_sd to b, free of tangential traction outside
};

/// Zones at the settled shift u; u must not exceed 1 - w^2.
ShakedownZones shakedown_zones(double w, double u);

/// Traction tau/(mu p0) at rho = r/a >= 0, axisymmetric: p(r) = -1/pi ∫ q'(x)/sqrt(x^2 - r^2) dx of
/// MDR's line load (u within c_sd, 1 - (|xi| + w)^2 in the slip zone), in closed form:
/// s(b) - s(c), s(x) = sqrt(x^2 - rho^2) + w acosh(x/rho) for x > rho, else zero.
double mdr_shakedown_traction(double rho, double w, double u);

}  // namespace tricontact::theory

#pragma once

#include <optional>

#include "contact/substrates/material.h"

namespace tricontact::theory {

// Oscillating rolling of a cylinder on an elastic half-space under constant normal and tangential
// force: the line contact, normal and tangential uncoupled, exactly. Dimensionless:
//   w = W/a in [0, 1]          rolling amplitude over the half width,
//   f = F_T/(mu F_N) in [0, 1] tangential force over the friction limit,
//   c = c_sd/a in [0, 1 - w]   half width of what always sticks; x over a likewise,
//   u = U/U_max                rigid shift over that of full sliding,
//   lambda                     contact::line_shift_factor(): U_max = mu 2 F_N/(pi E* L) lambda.
// After shakedown the points within c have never slipped: they have the displacement U. From c to
// b = a - W the traction is mu times the least pressure of a period, t(s) = sqrt(1 - (s + w)^2)
// over mu p0, and zero beyond. That is a superposition of flat punches of half widths r from c to
// b,
//   tau(x) = ∫_max(c,|x|)^b q(r)/sqrt(r^2 - x^2) dr,
// each of which displaces |x| < c uniformly; Abel's inversion of t gives q and, with s^2 = c^2 +
// v^2,
//   f = (4/pi) ∫_0^V t(s) dv,  V^2 = b^2 - c^2,
//   tau(x)/(mu p0) = (2/pi) ∫_0^V t(s) e/(e^2 + v^2) dv,  e^2 = c^2 - x^2,  for |x| < c.
// c = 0 is the limit, (3.5.27) of Wetter's thesis (TU Berlin); w = 0 is Cattaneo's line contact.
// The thesis' own tau (3.5.18) and f (3.5.24) are approximations, see oscillating_cylinder.h. Every
// function throws std::domain_error for an argument out of range.

/// f under which the half width c sticks after shakedown; decreasing in c.
double line_stick_force(double w, double c);
/// Its inverse in c; empty if f exceeds the limit (ratcheting).
std::optional<double> line_stick_half_width(double w, double f);

/// tau/(mu p0) at x (any sign) after shakedown.
double line_shakedown_traction(double x, double w, double c);

/// Displacement of the surface u_x/U_max at x (any sign, also beyond the contact) after shakedown:
/// u_sd for |x| <= c, and by each punch of half width r < |x| less, by acosh(|x|/r) of its load:
///   u_x = u_sd - (1/lambda) ∫_0^acosh(|x|/c) [f(c) - f(|x|/cosh eta)] d eta,
/// f(r) the load of all punches wider than r, line_stick_force(). c > 0.
double line_shakedown_displacement(double x, double w, double c, double lambda);

/// Shift u_stat under f before rolling: 1 - (1 - f) [1 - ln(1 - f)/(2 lambda)].
double line_static_shift_ratio(double f, double lambda);
/// Frictional work of one cycle of F_T between +-f mu F_N, over mu^2 2 F_N^2/(pi E* L):
/// f (2 - f) + 2 (1 - f) ln(1 - f), by Masing's rule from u_stat.
double line_cycle_dissipation(double f);
/// Shift u_sd after shakedown with the half width c sticking.
double line_settled_shift_ratio(double w, double c, double lambda);

/// Largest f that shakes down, (3.5.27): (2/pi) (acos w - w sqrt(1 - w^2)); also (1/F_N) ∫ min p
/// dA.
double line_shakedown_limit(double w);
/// Largest w that shakes down, its inverse.
double line_amplitude_limit(double f);

/// Slope d(Du)/dw [-] of the shift per period Du far beyond the limit, where w may exceed 1: each
/// way 2 W between turning points ends in steady rolling, with Carter's creepage (creep_law.h). By
/// 2 F_N/(pi E* L) = a^2/(2 R) that is 8 (1 - sqrt(1 - f))/lambda. Nearer to the limit no closed
/// form is known: what sticks then is carried along by what slips.
double line_steady_slope(double f, double lambda);

// What Wetter's thesis (TU Berlin, 2016, section 3.5) states of the oscillating cylinder beside the
// exact solution of oscillating_cylinder.h, whose dimensionless quantities these are. Its traction
// of the stick zone is the difference of two ellipses of the half widths b and c,
//   tau_2 = t21 sqrt(1 - x^2/b^2) - t22 sqrt(1 - x^2/c^2),  t22 = t21 c/b (3.5.18, 3.5.20),
// continuous at c (3.5.21). The ellipse of b goes on beyond c as another traction than the bound
// that is there, so that the displacement is not quite uniform within c.
// Every function throws std::domain_error for an argument out of range.

/// tau/(mu p0) at x, (3.5.17)-(3.5.22); 0 <= c < 1 - w.
double thesis_line_traction(double x, double w, double c);
/// f by the balance of that traction (3.5.24), with C = c + w, B = 1 - w, k = c/B:
///   (2/pi) acos C + (2/pi) sqrt(1 - C^2) {B [asin k - k^2 pi/2]/sqrt(1 - k^2) - w}.
double thesis_line_stick_force(double w, double c);
/// Its inverse; empty if f exceeds the limit.
std::optional<double> thesis_line_stick_half_width(double w, double f);

// Fits, printed with the sums of squares of table A.1.1.

/// u_stat = 1 - (1 - f)^0.92 (3.5.11).
double thesis_line_static_shift_ratio(double f);
/// u_sd = u_stat + 0.3 f w (3.5.26); empty if f exceeds the exact limit.
std::optional<double> thesis_line_settled_shift_ratio(double w, double f);
/// w_lim = 1 - f^0.73 (3.5.28).
double thesis_line_amplitude_limit(double f);
/// u_lim = f^0.87 (3.5.29).
double thesis_line_limit_shift_ratio(double f);
/// Shift per period 0.64 f (w - w_lim) with that w_lim (3.5.30), zero below it.
double thesis_line_increment(double w, double f);

}  // namespace tricontact::theory

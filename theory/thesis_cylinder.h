#pragma once

#include <optional>

#include "contact/substrates/material.h"

namespace tricontact::theory {

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
/// U_0 = mu 2 load/(pi E*) [(1 + ln 4)/2 + ln(1.8 (E*/G*) L/a)] [m] (3.5.12), `load` = F_N/L [N/m].
double thesis_line_unit_shift(const contact::MaterialPair& materials, double friction_coefficient,
                              double load, double length_ratio);
/// u_sd = u_stat + 0.3 f w (3.5.26); empty if f exceeds the exact limit.
std::optional<double> thesis_line_settled_shift_ratio(double w, double f);
/// w_lim = 1 - f^0.73 (3.5.28).
double thesis_line_amplitude_limit(double f);
/// u_lim = f^0.87 (3.5.29).
double thesis_line_limit_shift_ratio(double f);
/// Shift per period 0.64 f (w - w_lim) with that w_lim (3.5.30), zero below it.
double thesis_line_increment(double w, double f);

}  // namespace tricontact::theory

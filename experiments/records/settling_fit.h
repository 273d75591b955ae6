#pragma once

#include <vector>

#include "statistics/regression.h"

namespace tricontact::experiments {

using statistics::Estimate;

/// Shift at the ends of periods as a transient that dies out geometrically and steady ratcheting:
///   u_n = limit - A q^n + increment n,   n = 0 ... N.
/// Estimates with intervals by the profile of the sum of squares over q in [0, 0.95] (slower
/// transients look like ratcheting): all values for which it grows by no more than t^2/dof of its
/// minimum, t Student's. Asymmetric, finite whatever q, and wide where ratcheting and transient
/// cannot be told apart. Standard error: half the width over t.
struct SettlingFit {
    Estimate increment;  ///< Du per period of steady ratcheting [m]
    /// The limit without ratcheting, from the second half of the periods [m]: a contact settles by
    /// several transients, of which the slowest is left there.
    Estimate settled;
    double ratio = 0;               ///< q of the fit with ratcheting
    std::vector<double> fitted;     ///< of that fit [m]
    double residual_deviation = 0;  ///< of that fit [m]
};

/// Fewest periods: six values determine four parameters and their errors.
inline constexpr int fewest_periods = 5;

/// `shift`: u_0 ... u_N [m]. Throws std::invalid_argument for fewer than 5 periods.
SettlingFit fit_settling(const std::vector<double>& shift, double confidence);

/// Polynomial of least squares, coefficients of ascending powers.
statistics::Fit fit_polynomial(const std::vector<double>& x, const std::vector<double>& y,
                               int degree, double confidence = 0.95);

/// The thesis' criterion (5.1.5-5.1.8): second derivative of the parabola of least squares through
/// shift and time, both normalised to run from 0 to 1 in the interval. Negative is taken for
/// shakedown, positive for ratcheting. NaN if the shift is the same at both ends.
/// The interval is Student's, for independent errors: for values at the ends of periods.
Estimate normalised_curvature(const std::vector<double>& time, const std::vector<double>& shift,
                              double confidence);

}  // namespace tricontact::experiments

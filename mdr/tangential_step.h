#pragma once

#include <span>

namespace tricontact::mdr {

/// Increment of the rigid shift found for a prescribed force, and how.
struct ShiftSolution {
    double increment = 0;  ///< [m]
    int iterations = 0;
    double residual = 0;  ///< |sum of deflections - target| over the sum of the bounds [-]
};

/// All deflections u_i move by the same increment and are clamped to |u_i| <= bound_i [m]: finds
/// the increment at which they sum to `target` [m], |target| < sum of the bounds. The sum is a
/// monotone, piecewise linear function of the increment: Newton's method, bracketed, ends on the
/// exact piece. `farthest` [m]: no |u_i| + bound_i exceeds it. The search starts from zero.
/// Throws contact::NotConverged if rounding is not reached within 200 iterations.
ShiftSolution find_increment(std::span<const double> deflections, std::span<const double> bounds,
                             double target, double farthest);
/// The same where deflection i moves by the increment times `carried`_i, in (0, 1]: the share of
/// the step that is left when the indenter meets the spring. Farther than any
/// (|u_i| + bound_i)/carried_i is not searched.
ShiftSolution find_increment(std::span<const double> deflections, std::span<const double> bounds,
                             std::span<const double> carried, double target);

/// Sums over the springs in contact of one tangential step, the stiffness left out.
struct SlipSums {
    double deflection = 0;    ///< sum u [m]
    double dissipated = 0;    ///< sum |u s|, loads at the end of the step, s: slip [m^2]
    double trapezoidal = 0;   ///< sum (u + u_before) s / 2 [m^2]
    double stored = 0;        ///< sum (u^2 - u_before^2)/2 [m^2]
    double lowest_work = 0;   ///< least u s, negative if a slip does not oppose its load [m^2]
    double bound_excess = 0;  ///< greatest |u| - bound [m], or 0
    double n_stick = 0;       ///< springs that slipped by no more than the negligible amount
    double energy = 0;        ///< sum u^2/2 [m^2]
    double unmet = 0;         ///< sum u r/2, r: the increment less what carried the spring [m^2]
};

/// Takes the step: `after` = clamped deflections; slip = increment - change of deflection.
/// A slip up to `negligible` [m] counts as stick: rounding on the bound.
SlipSums take_step(std::span<const double> before, std::span<const double> bounds, double increment,
                   double negligible, std::span<double> after);
/// The same where spring i is carried along by its share of the increment, see find_increment().
SlipSums take_step(std::span<const double> before, std::span<const double> bounds,
                   std::span<const double> carried, double increment, double negligible,
                   std::span<double> after);

}  // namespace tricontact::mdr

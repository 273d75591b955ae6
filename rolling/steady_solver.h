#pragma once

#include <vector>

#include "contact/solvers/compliance.h"
#include "rolling/rolling_contact.h"

namespace tricontact::rolling {

/// Steady rolling at given pressures: find tractions t on the substrate, |t| <= bound, such that
/// the slip s of rolling_contact.h, du/dx the difference to the next cell ahead, vanishes where
/// |t| < bound and points along t where |t| = bound.
struct SteadyProblem {
    const std::vector<double>& bound;              ///< mu p [Pa] per point, 0 outside the contact
    const contact::TangentialField& displacement;  ///< by all but t [m]
    const Drive& drive;
};

struct SteadySolution {
    contact::TangentialField traction;      ///< t [Pa]
    contact::TangentialField displacement;  ///< A t [m]
    contact::TangentialField slip;          ///< s [-], 0 outside the contact
    Creepage creepage;
    int iterations = 0;         ///< applications of the compliance
    double residual = 0;        ///< see SteadySolver
    double force_residual = 0;  ///< |sum t A - F| / sum bound A, worst force-controlled direction
};

/// Semismooth Newton method (active set) as in contact::TangentialSolver, for the one state that
/// rolling on no longer changes: a monotone variational inequality, whose Newton systems are not
/// symmetric (see SteadySystem). Its solution is where transient rolling on the same grid ends.
///
/// Residual: largest |t - P(t + s/alpha)| over the mean bound, P the projection onto the friction
/// disc, alpha the slip over the traction of a single cell.
class SteadySolver {
  public:
    /// The points of `compliance` form a grid, which the contact does not reach the edge of.
    SteadySolver(const contact::Compliance& compliance, double tolerance);

    /// Updates `solution`, whose traction and creepage are the start (may be zero; clipped).
    /// Throws NotConverged; InputError when the force exceeds what friction carries.
    void solve(const SteadyProblem& problem, SteadySolution& solution) const;

  private:
    const contact::Compliance& compliance_;
    double tolerance_;
};

}  // namespace tricontact::rolling

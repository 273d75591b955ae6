#pragma once

#include <vector>

#include "contact/solvers/normal_grid.h"
#include "contact/solvers/normal_solver.h"

// Semismooth Newton method on grids too large for the other methods. The set of points in contact
// is that of the last pressures and penetrations; on it the gap is closed by preconditioned
// conjugate gradients, each step one convolution over the whole grid. The gap is closed to
// `reduction` only while the set still changes: an exact solution on a wrong set is wasted.
//
// Start: the same problem on the grid's `coarser()`, and so on down (nested iteration). Pressures
// of the coarser grid are interpolated; the contact's edge is then right to a coarse cell, and a
// few sets suffice on every level.
//
// Memory decides the layout. One field goes into products (`pressure_`), holding the pressures
// between sets, and gap or direction within `close_gap`; pressures of the set wait in `set_`
// meanwhile.

namespace tricontact::contact {

/// Normal contact on large grids: Newton's method on the set of points in contact (points that pull
/// leave, points that penetrate enter), inexact: the gap on a set is closed by a few preconditioned
/// conjugate gradients, no further than the set deserves. Without a start it begins on coarser
/// grids, one after the other.
class NormalNewton {
  public:
    NormalNewton(const NormalGrid& grid, double tolerance) : grid_(grid), tolerance_(tolerance) {}

    /// As NormalSolver::solve; iterations are products with the compliance on this grid. False when
    /// it does not settle: another method may.
    bool solve(const std::vector<double>& height, const NormalControl& control,
               const std::vector<double>& start, NormalSolution& solution) const;

  private:
    std::vector<double> start_from_coarser(const std::vector<double>& height,
                                           const NormalControl& control) const;

    const NormalGrid& grid_;
    double tolerance_;
};

}  // namespace tricontact::contact

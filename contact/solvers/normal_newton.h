#pragma once

#include <vector>

#include "contact/solvers/normal_grid.h"
#include "contact/solvers/normal_solver.h"

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

#pragma once

#include <vector>

#include "contact/compliances/steady_compliance.h"
#include "contact/load_path.h"
#include "contact/solvers/normal_solver.h"

namespace tricontact::rolling {

/// Frictionless normal contact on a body that rolls on steadily: as contact::NormalSolver, whose
/// conjugate gradients need a self-adjoint compliance. Active set as in Kalker (1990),
/// Three-Dimensional Elastic Bodies in Rolling Contact, ch. 4, NORM: the gap of the present points
/// is closed, those that pull are taken out until none does, then those that penetrate are added.
/// Of a compliance whose symmetric part is positive definite the solution is the only one.
class SteadyNormalSolver {
  public:
    /// `tolerance`: on contact::NormalSolution::residual. The points form a grid.
    SteadyNormalSolver(const contact::SteadyCompliance& compliance, double tolerance);

    /// `start`: pressures of a similar problem, or empty. Throws contact::NotConverged.
    contact::NormalSolution solve(const std::vector<double>& height,
                                  const contact::NormalControl& control,
                                  const std::vector<double>& start) const;

  private:
    const contact::SteadyCompliance& compliance_;
    double tolerance_;
    double local_;  // displacement of a cell over its own pressure [m/Pa]
};

}  // namespace tricontact::rolling

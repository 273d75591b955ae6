#pragma once

#include "dynamics/machine.h"
#include "dynamics/motion.h"
#include "dynamics/walk_result.h"

namespace tricontact::dynamics {

/// Adds to the errors of a limit cycle's mu_e and period what the integration's step contributes:
/// the cycle is followed once more with half the step. Velocity Verlet makes errors of second
/// order in these means, so that four thirds of the difference remain (Richardson).
/// `motion`: of the machine's springs, on the cycle; `result` is of a limit cycle.
void add_step_error(const Machine& machine, const Motion& motion, double step, WalkResult& result);

}  // namespace tricontact::dynamics

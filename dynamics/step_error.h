#pragma once

#include <span>

#include "dynamics/machine.h"
#include "dynamics/walk_record.h"

namespace tricontact::dynamics {

/// Adds to the errors of a limit cycle's mu_e and period what the integration's step contributes:
/// the cycle is followed once more with half the step. Velocity Verlet makes errors of second
/// order in these means, so that four thirds of the difference remain (Richardson).
/// `returns`: those that were judged; `result` is of a limit cycle.
void add_step_error(const Machine& machine, std::span<const SectionReturn> returns, double step,
                    WalkResult& result);

}  // namespace tricontact::dynamics

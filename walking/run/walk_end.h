#pragma once

#include <cstdint>
#include <optional>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/run/snapshot_recorder.h"
#include "walking/run/walk_recorder.h"
#include "walking/run/walk_result.h"
#include "walking/run/walk_run.h"

namespace tricontact::walking {

/// Numbers of steps that a case and what is to be recorded of it stand for.
struct WalkSteps {
    std::int64_t run = 0;       ///< in the run
    std::int64_t window = 0;    ///< in a window
    std::int64_t snapshot = 0;  ///< between snapshots
    std::int64_t tail = 0;      ///< of the end that is recorded densely
    std::int64_t judged = 0;    ///< of the end in which limit cycles are looked for
};

/// Throws std::invalid_argument if step or end are not positive.
WalkSteps steps_of(const WalkCase& walk_case, const Recording& recording);

/// Runs on for so many steps, or until the machine tilts; returns the time of that.
std::optional<double> follow(VelocityVerlet& run, std::int64_t n_steps, std::int64_t every,
                             WalkRecorder& recorder, SnapshotRecorder& snapshots);

/// What follows from windows and returns: the result, the tail and its phases. `snapshots` are of
/// the last steps_of().judged steps at least, or of the tail where there is no limit cycle; `end`
/// is the motion of the springs there.
void conclude(const WalkCase& walk_case, const Recording& recording, const Motion& end,
              std::optional<double> tilting_time, const SnapshotRecorder& snapshots, Walk& walk);

/// Adds to the errors of a limit cycle's mu_e and period what the integration's step contributes:
/// the cycle is followed once more with half the step. Velocity Verlet makes errors of second
/// order in these means, so that four thirds of the difference remain (Richardson).
/// `motion`: of the machine's springs, on the cycle; `result` is of a limit cycle.
void add_step_error(const Machine& machine, const Motion& motion, double step, WalkResult& result);

}  // namespace tricontact::walking

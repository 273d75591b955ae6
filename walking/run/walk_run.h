#pragma once

#include "walking/machine/walk_case.h"
#include "walking/machine/walk_record.h"

namespace tricontact::walking {

/// What to record densely; times in units of sqrt(m/k_x).
struct Recording {
    double start = 0;        ///< length of the first stretch
    double tail = 20;        ///< of the last one, at least; three periods of a limit cycle
    double interval = 0.01;  ///< between snapshots; at least a step
};

/// Runs a case by velocity Verlet and judges it. A machine that tilts is stopped there.
/// Throws std::invalid_argument if step or end are not positive.
Walk walk(const WalkCase& walk_case, const Recording& recording = {});

}  // namespace tricontact::walking

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "walking/machine/motion.h"
#include "walking/machine/stretch_recorder.h"
#include "walking/run/drift.h"
#include "walking/run/walk_phases.h"
#include "walking/run/walk_result.h"

namespace tricontact::walking {

/// A stretch of the run and what happened in it.
struct WalkWindow {
    double begin = 0, end = 0;  ///< times
    StretchSums sums;
};

/// A return to the Poincare section, and what happens from there until the next one. The section is
/// where the body gets as fast as the spring's base: x' rises through kappa6. It is met once a
/// swing of the spring, whether the body jumps, slides or cannot move vertically.
struct SectionReturn {
    Motion motion;  ///< interpolated between two steps: an error of the order of the step squared
    StretchSums sums;  ///< up to the next return
};

/// One machine's run.
struct Walk {
    WalkResult result;
    std::vector<WalkWindow> windows;     ///< of equal length, the whole run
    std::vector<SectionReturn> returns;  ///< of the end of the run, in the order of time
    std::vector<ExcitedPeriod> periods;  ///< of an excitation while the base stands still
    std::vector<Snapshot> start, tail;   ///< first and last stretch, densely
    Motion last;                         ///< at the end, spring by spring; of a run alone
    std::optional<WalkPhases> phases;    ///< of the limit cycle, if it is one
    std::int64_t lane_steps = 0;         ///< steps of one machine
    double cpu_s = 0;                    ///< processor time of the run [s]
};

}  // namespace tricontact::walking

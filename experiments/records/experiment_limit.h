#pragma once

#include <cstddef>
#include <optional>

#include "experiments/records/experiment_run.h"

namespace tricontact::experiments {

/// Two straight lines of least squares and where they meet.
struct LineIntersection {
    double time = 0;            ///< [s]
    Estimate shift;             ///< U_lim [m]
    double slopes[2] = {0, 0};  ///< before and after [m/s]
};

/// The shakedown limit of a run whose amplitude rises in steps.
struct LimitReading {
    std::size_t shakedown = 0, ratcheting = 0;     ///< stages: last and first of the kind
    double amplitude_low = 0, amplitude_high = 0;  ///< theirs: W_lim lies between [m]
    LineIntersection lines;
};

/// The stage of the first ratcheting and the last shakedown before it, by one of the verdicts of
/// stages; stages in between that cannot be told widen the interval. Empty if either is missing.
std::optional<LimitReading> read_limit(const RunEvaluation& run,
                                       contact::State StageEvaluation::*verdict, double confidence);

/// Intersection of the straight lines through the values at the ends of periods of two stages
/// (thesis 5.1.9, 5.1.10), errors of both lines propagated; Student's t of the line with the fewer
/// values. NaN error and interval where the lines are nearly parallel.
LineIntersection intersect(const StageEvaluation& before, const StageEvaluation& after,
                           double confidence);

}  // namespace tricontact::experiments

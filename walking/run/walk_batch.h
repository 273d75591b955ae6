#pragma once

#include <span>
#include <vector>

#include "walking/kernels/batch.h"
#include "walking/run/walk_run.h"

namespace tricontact::walking {

/// Runs cases of one step and one end side by side in a batch, each as walk() does: it depends
/// neither on the others nor on the number of threads. Returns are recorded only where the extremes
/// of the motion repeat, so that there may be a limit cycle; the time of computing is an equal
/// share of the whole. Throws std::invalid_argument for what a batch does not know, and for cases
/// that differ in step or end.
std::vector<Walk> walk_batch(std::span<const WalkCase> cases, const Recording& recording = {},
                             const BatchOptions& options = {});

}  // namespace tricontact::walking

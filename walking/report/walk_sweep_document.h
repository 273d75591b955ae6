#pragma once

#include <optional>

#include "report/document.h"
#include "walking/report/walk_map.h"
#include "walking/study/walk_sweep.h"

namespace tricontact::walking {

/// A study of walking machines: how many slide, walk, stay chaotic or tilt, and what its axes ask
/// for. Two axes of the machine with at least eight numbers each: a map. Lists of two to four
/// numbers: main effects and effects of pairs. Starts alone: what they change. Else curves of
/// friction. Starts beside other axes are repetitions, over which means are taken. Files, command
/// and version are the caller's.
report::Document walk_sweep_document(const WalkSweep& sweep);

/// The map that a page shows; empty unless the study is a map of kappa8 and friction.
std::optional<WalkMap> walk_map_of(const WalkSweep& sweep);

}  // namespace tricontact::walking

#pragma once

#include <string>

#include "dynamics/walk_result.h"

namespace tricontact::comparisons::walking {

/// What a map tells a run by: its regime, if it lasted long enough to have one.
enum class MotionClass { steady, limit_cycle, chaotic, unsettled, fallen };
inline constexpr int n_motion_classes = 5;

MotionClass motion_class(const dynamics::WalkResult& result);

/// "slides steadily", "walks in a limit cycle", ...
std::string words_of(MotionClass motion);

}  // namespace tricontact::comparisons::walking

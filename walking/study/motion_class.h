#pragma once

#include <string>

#include "walking/run/walk_result.h"

namespace tricontact::walking {

/// What a map tells a run by: its regime, if it lasted long enough to have one.
enum class MotionClass { steady, limit_cycle, chaotic, unsettled, fallen };
inline constexpr int n_motion_classes = 5;

MotionClass motion_class(const WalkResult& result);

/// "slides steadily", "walks in a limit cycle", ...
std::string words_of(MotionClass motion);

}  // namespace tricontact::walking

#pragma once

#include <optional>
#include <vector>

#include "comparisons/document.h"
#include "comparisons/walking/vibration.h"
#include "comparisons/walking/walk_report.h"

namespace tricontact::comparisons::walking {

/// What a run came to, whether it was long enough, whether the body jumps and its spots move where
/// they press little.
std::vector<Verdict> walk_verdicts(const WalkReport& report,
                                   const std::optional<Vibration>& vibration);

}  // namespace tricontact::comparisons::walking

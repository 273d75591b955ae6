#pragma once

#include <string>

#include "dynamics/walk_result.h"

namespace tricontact::comparisons::walking {

/// What a run came to, in words of its own: "slides steadily", "walks in a limit cycle", ...
std::string words_of(dynamics::Regime regime);

}  // namespace tricontact::comparisons::walking

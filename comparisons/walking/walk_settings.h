#pragma once

#include <string>
#include <utility>
#include <vector>

#include "dynamics/walk_case.h"

namespace tricontact::comparisons::walking {

/// What a case says, as name and value: kappas, what follows from them, dimensions, mechanisms that
/// are switched off, time and start.
std::vector<std::pair<std::string, std::string>> walk_settings(const dynamics::WalkCase& walk_case);

}  // namespace tricontact::comparisons::walking

#pragma once

#include <string>

#include "dynamics/walk_case.h"
#include "dynamics/walk_record.h"

namespace tricontact::comparisons::walking {

/// A line for each window of the run: its means and extremes. Ratios as in WalkResult.
std::string windows_csv(const dynamics::WalkCase& walk_case, const dynamics::Walk& walk);

/// A line for each recorded state of the end of the run: motion, spring force and, spot by spot,
/// forces and state (0 released, 1 stick, 2 slip). Lengths in units of b, times of sqrt(m/k_x),
/// forces of k_x b; of a machine with dimensions also the time in s and the spring force in N.
std::string motion_csv(const dynamics::WalkCase& walk_case, const dynamics::Walk& walk);

}  // namespace tricontact::comparisons::walking

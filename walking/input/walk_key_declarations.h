#pragma once

#include <vector>

#include "io/keys/key_kinds.h"
#include "walking/input/walk_keys.h"

namespace tricontact::walking {

/// Groups of alternative keys of walking cases: exactly one of each group, or its default.
enum WalkKeyGroup { no_walk_group = 0, lever_arm, spot_stiffness, end_of_run };

/// Declarations of the section [machine].
void add_machine_keys(std::vector<WalkKey>& keys);

}  // namespace tricontact::walking

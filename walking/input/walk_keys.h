#pragma once

#include <vector>

#include "io/keys/key.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking {

/// Declaration of one key of a case of the micro-walking machine.
using WalkKey = io::PlacedKey<WalkCase>;

/// All keys in the order in which they are written.
const std::vector<WalkKey>& walk_keys();
const io::KeyList& walk_key_list();
/// These and those of a rig: all that a file may hold, but for the names in [printed].
const io::KeyList& walk_file_keys();

/// Whether the key describes a machine with dimensions, whose kappas follow.
bool is_dimensional(const io::Key& key);

/// Groups of alternative keys of walking cases: exactly one of each group, or its default.
enum WalkKeyGroup { no_walk_group = 0, lever_arm, spot_stiffness, end_of_run };

}  // namespace tricontact::walking

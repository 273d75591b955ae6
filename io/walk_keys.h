#pragma once

#include <span>
#include <string_view>

#include "dynamics/walk_case.h"
#include "io/key.h"
#include "io/key_list.h"

namespace tricontact::io {

/// Declaration of one key of a case of the micro-walking machine.
struct WalkKey : Key {
    Field (*field)(dynamics::WalkCase&) = nullptr;
};

/// All keys in the order in which they are written.
std::span<const WalkKey> walk_keys();
const KeyList& walk_key_list();

/// Whether the key describes a machine with dimensions, whose kappas follow.
bool is_dimensional(const Key& key);

}  // namespace tricontact::io

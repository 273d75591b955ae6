#pragma once

#include <span>
#include <string_view>

#include "io/keys/key.h"
#include "io/keys/key_list.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking {

/// Declaration of one key of a case of the micro-walking machine.
struct WalkKey : io::Key {
    io::Field (*field)(WalkCase&) = nullptr;
};

/// All keys in the order in which they are written.
std::span<const WalkKey> walk_keys();
const io::KeyList& walk_key_list();

/// Whether the key describes a machine with dimensions, whose kappas follow.
bool is_dimensional(const io::Key& key);

}  // namespace tricontact::walking

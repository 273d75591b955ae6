#pragma once

#include <string>
#include <string_view>

#include "experiments/assumptions/rig.h"

namespace tricontact::experiments {

/// Reads a rig file (docs/rig.md). Throws contact::InputError in one line:
/// `file:line:column: key = value: rule; remedy`.
Rig read_rig(const std::string& path);

/// Same for a text; `name` stands for the file in messages.
Rig parse_rig(std::string_view text, const std::string& name);

}  // namespace tricontact::experiments

#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/assumptions/rig.h"
#include "io/keys/units.h"

namespace tricontact::experiments {

using Rig = std::variant<RollingRig, WalkingRig>;

/// Reads a rig file (docs/rig.md). Throws contact::InputError in one line:
/// `file:line:column: key = value: rule; remedy`.
Rig read_rig(const std::string& path);

/// Same for a text; `name` stands for the file in messages.
Rig parse_rig(std::string_view text, const std::string& name);

/// A quantity whose printed value may be compared.
struct PrintedKey {
    std::string_view name;
    io::Dimension dimension = io::Dimension::none;
};
const std::vector<PrintedKey>& printed_keys(const RollingRig& rig);
const std::vector<PrintedKey>& printed_keys(const WalkingRig& rig);

}  // namespace tricontact::experiments

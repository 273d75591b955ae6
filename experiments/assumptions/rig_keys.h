#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "experiments/assumptions/rig.h"
#include "io/keys/key.h"

namespace tricontact::experiments {

/// One quantity of a rig file, and its place in a rig.
struct RigKey {
    std::string_view path;  ///< "section.key"
    io::Dimension dimension = io::Dimension::none;
    io::Range range = {};
    std::string_view example;  ///< TOML
    /// Monostate: its part of the rig is absent.
    std::variant<std::monostate, statistics::Uncertain*, std::optional<statistics::Uncertain>*>
        target;

    /// Must stand in the file, if its section does.
    bool required() const { return std::holds_alternative<statistics::Uncertain*>(target); }
};

/// Keys of a rig, places in it included: it must outlive them.
std::vector<RigKey> rig_keys(RollingRig& rig);
std::vector<RigKey> rig_keys(WalkingRig& rig);

/// A quantity whose printed value may be compared.
struct PrintedKey {
    std::string_view name;
    io::Dimension dimension = io::Dimension::none;
};
const std::vector<PrintedKey>& printed_keys(const RollingRig& rig);
const std::vector<PrintedKey>& printed_keys(const WalkingRig& rig);

}  // namespace tricontact::experiments

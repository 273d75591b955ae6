#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "contact/rolling_rig.h"
#include "contact/walking_rig.h"
#include "io/key.h"

namespace tricontact::io {

/// One quantity of a rig file, and its place in a rig.
struct RigKey {
    std::string_view path;  ///< "section.key"
    Dimension dimension = Dimension::none;
    Range range = {};
    std::string_view example;  ///< TOML
    /// Monostate: its part of the rig is absent.
    std::variant<std::monostate, contact::Uncertain*, std::optional<contact::Uncertain>*> target;

    /// Must stand in the file, if its section does.
    bool required() const { return std::holds_alternative<contact::Uncertain*>(target); }
};

/// Keys of a rig, places in it included: it must outlive them.
std::vector<RigKey> rig_keys(contact::RollingRig& rig);
std::vector<RigKey> rig_keys(contact::WalkingRig& rig);

/// A quantity whose printed value may be compared.
struct PrintedKey {
    std::string_view name;
    Dimension dimension = Dimension::none;
};
const std::vector<PrintedKey>& printed_keys(const contact::RollingRig& rig);
const std::vector<PrintedKey>& printed_keys(const contact::WalkingRig& rig);

}  // namespace tricontact::io

#pragma once

#include <string>

#include "dynamics/walk_case.h"
#include "dynamics/walk_record.h"

// What a walking machine did, in texts.
namespace tricontact::app {

/// What a run came to, as lines for people.
std::string walk_text(const dynamics::WalkCase& walk_case, const dynamics::Walk& walk);

/// What follows from a case of the walking machine, as comments of a TOML file.
std::string walk_scales_text(const dynamics::WalkCase& c);

/// The text of a walking machine's summary.json. `resolved` is the case as text.
std::string walk_summary(const dynamics::WalkCase& walk_case, const std::string& resolved,
                         const dynamics::Walk& walk);

}  // namespace tricontact::app

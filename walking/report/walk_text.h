#pragma once

#include <string>

#include "walking/machine/walk_case.h"
#include "walking/machine/walk_record.h"

// What a walking machine did, in texts.
namespace tricontact::walking {

/// What a run came to, as lines for people.
std::string walk_text(const WalkCase& walk_case, const Walk& walk);

/// What follows from a case of the walking machine, as comments of a TOML file.
std::string walk_scales_text(const WalkCase& c);

/// The text of a walking machine's summary.json. `resolved` is the case as text.
std::string walk_summary(const WalkCase& walk_case, const std::string& resolved, const Walk& walk);

}  // namespace tricontact::walking

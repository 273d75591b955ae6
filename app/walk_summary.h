#pragma once

#include <string>

#include "dynamics/walk_case.h"
#include "dynamics/walk_record.h"

namespace tricontact::app {

/// The text of a walking machine's summary.json. `resolved` is the case as text.
std::string walk_summary(const dynamics::WalkCase& walk_case, const std::string& resolved,
                         const dynamics::Walk& walk);

}  // namespace tricontact::app

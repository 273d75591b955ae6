#pragma once

#include <string>

#include "dynamics/walk_case.h"
#include "dynamics/walk_record.h"

namespace tricontact::app {

/// What a run came to, as lines for people.
std::string walk_text(const dynamics::WalkCase& walk_case, const dynamics::Walk& walk);

}  // namespace tricontact::app

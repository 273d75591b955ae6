#pragma once

#include <string>

#include "dynamics/walk_case.h"

namespace tricontact::app {

/// What follows from a case of the walking machine, as comments of a TOML file.
std::string walk_scales_text(const dynamics::WalkCase& c);

}  // namespace tricontact::app

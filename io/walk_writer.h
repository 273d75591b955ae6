#pragma once

#include <string>

#include "dynamics/walk_case.h"

namespace tricontact::io {

/// The resolved case as TOML, as write_case does it. `parse_walk_case` of the text yields the same
/// case.
std::string write_walk_case(const dynamics::WalkCase& c);

}  // namespace tricontact::io

#pragma once

#include <string>

#include "contact/case.h"
#include "dynamics/walk_case.h"

namespace tricontact::io {

/// The resolved case as TOML: every default written out, quantities in SI units with the shortest
/// digits that read back the same. `parse_case` of the text yields a bit-identical case.
std::string write_case(const contact::Case& c);

/// The resolved case as TOML, as write_case does it. `parse_walk_case` of the text yields the same
/// case.
std::string write_walk_case(const dynamics::WalkCase& c);

}  // namespace tricontact::io

#pragma once

#include <string>

#include "contact/case.h"

namespace tricontact::io {

/// The resolved case as TOML: every default written out, quantities in SI units with the shortest
/// digits that read back the same. `parse_case` of the text yields a bit-identical case.
std::string write_case(const contact::Case& c);

}  // namespace tricontact::io

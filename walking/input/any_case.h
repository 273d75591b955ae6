#pragma once

#include <string>
#include <variant>
#include <vector>

#include "contact/case.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking {

/// What a case file may be about: a contact, or the micro-walking machine.
using AnyCase = std::variant<contact::Case, WalkCase>;

/// Reads a case of the kind that the file is; see read_case and read_walk_case. Throws
/// contact::InputError.
AnyCase read_any_case(const std::string& path, const std::vector<std::string>& overrides = {});

}  // namespace tricontact::walking

#pragma once

#include <string>

#include "contact/case.h"

namespace tricontact::comparisons {

/// What models take for granted of a case that has it otherwise: bits of a set. What a case has and
/// a model leaves out, key by key, is told from them by left_out().
enum Trait : unsigned {
    springs = 1,
    half_space = 2,
    uncoupled = 4,
    small_strains = 8,
    half_space_indenter = 16
};

/// Those of a model.
unsigned traits_of(const contact::Case& c, const std::string& model);

/// "half-space, no coupling".
std::string names_of(unsigned traits);

}  // namespace tricontact::comparisons

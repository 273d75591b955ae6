#pragma once

#include <string>
#include <vector>

#include "comparisons/quantities/results.h"

namespace tricontact::comparisons {

/// What the models of a case leave out, a sentence each, so that not more is read into them.
std::vector<std::string> limitations(const contact::Case& c, const std::vector<Results>& results);

/// Models for which a closed form of uncoupled, elastic half-spaces decides.
std::vector<std::string> uncoupled_half_spaces(const contact::Case& c,
                                               const std::vector<Results>& results);

}  // namespace tricontact::comparisons

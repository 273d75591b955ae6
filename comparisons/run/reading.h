#pragma once

#include <string>
#include <vector>

#include "comparisons/quantities/results.h"
#include "contact/case.h"

namespace tricontact::comparisons {

/// The results in plain sentences, one finding each, most important first; plain text (not HTML).
/// The last summary is the one the others are compared with.
std::vector<std::string> reading(const contact::Case& c, const std::vector<Results>& summaries);

}  // namespace tricontact::comparisons

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparisons/quantities/results.h"

namespace tricontact::comparisons {

/// Why kappa of a contact that settles, eta of one that ratchets, or the peak pressure has no
/// value.
std::vector<std::pair<const Quantity*, std::string>> why_undefined(const contact::Case& c,
                                                                   const Results& results);

}  // namespace tricontact::comparisons

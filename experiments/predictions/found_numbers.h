#pragma once

#include <string>
#include <vector>

#include "experiments/identification/law_comparison.h"

namespace tricontact::experiments {

// What tables tell of a case, for the models that compute it.

/// key=value of the law of friction, all its numbers, and of what else was found of `c`.
std::vector<std::string> overrides_of(contact::Case c, const Identification& found);

/// Why a law's numbers are not those of a case; empty if they are.
std::string why_untold(const LawFit& fit);
bool is_at_an_end(const LawFit& fit);
/// The end of n that is no narrower law.
bool has_largest_exponent(const LawFit& fit);

}  // namespace tricontact::experiments

#pragma once

#include <string>
#include <vector>

#include "comparisons/quantities/results.h"
#include "contact/case.h"

namespace tricontact::comparisons {

/// "55.9 µm (0.4755 U_max)": a length beside its ratio.
std::string with_ratio(const Results& results, const Quantity& length, const Quantity& ratio);

/// The results in plain sentences, one finding each, most important first; plain text (not HTML).
/// The last summary is the one the others are compared with.
std::vector<std::string> reading(const contact::Case& c, const std::vector<Results>& summaries);

/// What the models of a case leave out, a sentence each, so that not more is read into them.
std::vector<std::string> limitations(const contact::Case& c, const std::vector<Results>& results);

/// Of these, what the models make of the case's bodies and of its rolling, for answers without a
/// report: a layer that is not seen, no coupling, one direction. Empty where nothing is left out.
std::vector<std::string> body_limitations(const contact::Case& c,
                                          const std::vector<std::string>& models);

/// Models for which a closed form of uncoupled, elastic half-spaces decides.
std::vector<std::string> uncoupled_half_spaces(const contact::Case& c,
                                               const std::vector<Results>& results);

}  // namespace tricontact::comparisons

#pragma once

#include <string>
#include <vector>

#include "comparisons/run/loading_study.h"
#include "comparisons/run/report_tables.h"
#include "contact/case.h"

namespace tricontact::comparisons {

/// How the models treat coupling, displaced surface and pressing, and what other choices would
/// change, in plain sentences. `models`: those of the case.
std::vector<std::string> treatment_sentences(const contact::Case& c,
                                             const std::vector<std::string>& models,
                                             const std::vector<LoadingVariant>& variants);

/// Shifts after loading and, where it was computed, after rolling with one choice changed.
report::DocumentTable variants_table(const std::vector<LoadingVariant>& variants);

}  // namespace tricontact::comparisons

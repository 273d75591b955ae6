#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/loading_study.h"
#include "contact/case.h"

namespace tricontact::comparisons {

/// How the models treat coupling and pressing, and what other choices would change, in plain
/// sentences. `models`: those of the case.
std::vector<std::string> treatment_sentences(const contact::Case& c,
                                             const std::vector<std::string>& models,
                                             const std::vector<LoadingVariant>& variants);

/// "151.6 µm instead of 150.6 µm (+0.64 %)": the error that of the changed one.
std::string instead(std::optional<double> changed, std::optional<double> chosen,
                    std::optional<double> error, const char* unit = "m");

}  // namespace tricontact::comparisons

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "comparisons/quantities/results.h"

namespace tricontact::comparisons {

/// The text of summary.json: fixed keys in fixed order, undefined and non-finite numbers as null.
/// `resolved_case` becomes the value of "case"; `sections` is an object whose members stand behind
/// the models, unless they are empty: "layer" (see layer.h), "loading_variants" (loading_study.h),
/// "relaxation" (relaxation_report.h).
std::string summary_json(const std::string& version, const nlohmann::ordered_json& resolved_case,
                         const std::vector<Results>& results,
                         const nlohmann::ordered_json& sections = nlohmann::ordered_json::object());

}  // namespace tricontact::comparisons

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// Names of what one point of a sweep is asked for, in the order of the table; units in the names,
/// meanings as in ModelSummary. They never change with the case.
const std::vector<std::string>& point_result_names();

/// Values by name: numbers, words, or null where a quantity is undefined. No times: the same case
/// gives the same values.
nlohmann::ordered_json point_results(const contact::Case& c, const contact::History& history);

}  // namespace tricontact::comparisons

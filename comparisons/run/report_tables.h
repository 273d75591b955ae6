#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparisons/quantities/results.h"
#include "comparisons/resolution/numerical_error.h"
#include "contact/case.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// Names and values with units of what a case gives: bodies, load and rolling path.
std::vector<std::pair<std::string, std::string>> settings_of(const contact::Case& c);

/// What follows from bodies and load by Hertz.
report::DocumentTable derived_table(const contact::Case& c);

/// Models side by side, the closed forms, and differences to the last model (with one model: to
/// the closed forms); a table per part, none where nothing is known. The last model's numbers stand
/// with their `error`.
std::vector<report::DocumentTable> results_tables(const contact::Case& c,
                                                  const std::vector<Results>& results,
                                                  const std::optional<NumericalError>& error = {});

/// u, its increment and the frictional work after each period.
report::DocumentTable period_table(const std::vector<Results>& results);

/// Each model's checks: worst violation, what is allowed, verdict.
report::DocumentTable audit_table(const std::vector<Results>& results);

}  // namespace tricontact::comparisons

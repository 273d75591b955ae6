#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/results.h"
#include "comparisons/resolution/numerical_error.h"
#include "comparisons/run/report.h"
#include "contact/case.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// What a run is asked for, and what the models are compared by.
struct Headline {
    const char* words;       ///< "settled shift"
    const Quantity* length;  ///< or, where that is prescribed, what it takes: work, force
    const Quantity* ratio;   ///< of a length, over U_max; else null
};
Headline headline_of(const contact::Case& c, const Results& results);

/// The question of a case answered by its reference, the last model: state, shift with the error of
/// mesh and steps, or that of the finest level of a refinement. Empty width: not known.
report::Verdict answer_of(const contact::Case& c, const Results& reference,
                          const std::optional<NumericalError>& error,
                          const std::optional<Refinement>& refinement = {});

/// A row per model, the reference first: state, its number, how far it is off the reference in
/// metres, and what it takes for granted that the reference does not.
report::DocumentTable models_table(const contact::Case& c, const std::vector<Results>& results,
                                   const std::optional<NumericalError>& error);

/// What assumptions change in the verdict or in the headline's number, each with who was held
/// against whom: they fail from 5 % on. The last one names those that nothing in this run tests.
std::vector<report::Verdict> assumption_verdicts(const contact::Case& c,
                                                 const std::vector<Results>& results,
                                                 const ReportExtras& extras);

}  // namespace tricontact::comparisons

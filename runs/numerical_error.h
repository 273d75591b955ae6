#pragma once

#include <optional>

#include "comparisons/resolution/numerical_error.h"
#include "contact/history.h"
#include "runs/options.h"

namespace tricontact::runs {

/// What mesh and steps leave in the numbers of a model, by runs on coarser ones with no more files;
/// `history` is that of the case's run. Empty unless `options` want studies.
std::optional<comparisons::NumericalError> numerical_error(const Case& c,
                                                           const contact::History& history,
                                                           const RunOptions& options,
                                                           const Say& say);

}  // namespace tricontact::runs

#pragma once

#include "comparisons/shakedown/study_fit.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// Settled shifts, limits and increments of a study of line contacts beside the exact solution on
/// the half-space (theory/oscillating_cylinder.h) and the thesis' fits, its figures 3.40 and 3.43
/// to 3.46. `shift_factor`: lambda of all its cases, contact::line_shift_factor().
report::Document line_fit_document(const StudyFit& fit, double shift_factor);

}  // namespace tricontact::comparisons

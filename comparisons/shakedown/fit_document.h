#pragma once

#include <vector>

#include "comparisons/shakedown/study_fit.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// Parts of fit_document: what the fits say in sentences,
std::vector<report::Verdict> fit_verdicts(const StudyFit& fit);

/// and in tables: fits of kappa, shifts by one kappa, fits of limits and ratcheting, models side
/// by side. Empty tables are left out by their user.
report::DocumentTable mapping_table(const StudyFit& fit);
report::DocumentTable mapping_use_table(const StudyFit& fit);
report::DocumentTable ratcheting_table(const StudyFit& fit);
report::DocumentTable difference_table(const StudyFit& fit);

/// Every difference of every point.
report::DocumentTable point_difference_table(const StudyFit& fit);

}  // namespace tricontact::comparisons

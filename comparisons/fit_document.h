#pragma once

#include <vector>

#include "comparisons/document.h"
#include "comparisons/study_fit.h"

namespace tricontact::comparisons {

/// Parts of fit_document: what the fits say in sentences,
std::vector<Verdict> fit_verdicts(const StudyFit& fit);

/// and in tables: fits of kappa, shifts by one kappa, fits of limits and ratcheting, models side
/// by side. Empty tables are left out by their user.
DocumentTable mapping_table(const StudyFit& fit);
DocumentTable mapping_use_table(const StudyFit& fit);
DocumentTable ratcheting_table(const StudyFit& fit);
DocumentTable difference_table(const StudyFit& fit);

/// Every difference of every point.
DocumentTable point_difference_table(const StudyFit& fit);

}  // namespace tricontact::comparisons

#pragma once

#include <vector>

#include "comparisons/shakedown/study_fit.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// Figures of Wetter's thesis with its formulas drawn over the points of the models, per group
/// along (3.16, 3.17, 3.18, 3.20, 3.21) or across the rolling (3.30, 3.31, 3.32, 3.20, 3.33), as
/// far as the study has points for them. Other directions have none.
std::vector<report::Figure> thesis_figures(const StudyFit& fit);

}  // namespace tricontact::comparisons

#pragma once

#include <vector>

#include "contact/case.h"
#include "contact/history.h"
#include "report/document.h"
#include "report/figure.h"

namespace tricontact::comparisons {

/// Force over depth, and contact radius over force, of surfaces that attract each other along a
/// path; with the whole curves of adhesive_equilibria(), their unstable parts included. None of
/// other cases.
std::vector<report::Figure> force_curve_figures(const contact::Case& c,
                                                const std::vector<contact::History>& histories);

/// The steps in which contact jumped, and what each lost.
report::DocumentTable jump_table(const std::vector<contact::History>& histories);

}  // namespace tricontact::comparisons

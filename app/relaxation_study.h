#pragma once

#include "app/case_run.h"
#include "comparisons/quantities/relaxation_study.h"
#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::app {

/// Adds to `study` what the drive means for a relaxing case and, if `options` want studies, the
/// comparison of `history`, that of the case's run with a model, with a run on the elastic twin of
/// the substrate. The first model that comes here then also looks for the slowest drive speed at
/// which the twin errs by 1 % (find_speed_limit). Finite elements are too dear for either. Elastic
/// cases add nothing.
void study_relaxation(const contact::Case& c, const contact::History& history,
                      const RunOptions& options, const Say& say,
                      comparisons::RelaxationStudy& study);

}  // namespace tricontact::app

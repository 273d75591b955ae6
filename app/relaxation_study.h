#pragma once

#include "app/models.h"
#include "comparisons/relaxation_study.h"
#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::app {

/// Runs a relaxing case once more on the elastic twin of its substrate and adds the comparison with
/// `history`, that of the case's run with the same model, to `study`. The first model that comes
/// here also looks for the slowest drive speed at which the twin errs by 1 % (find_speed_limit).
/// Finite elements are too dear for both: they add their drive values only. Elastic cases add
/// nothing.
void study_relaxation(const contact::Case& c, const contact::History& history, int n_threads,
                      const Say& say, comparisons::RelaxationStudy& study);

}  // namespace tricontact::app

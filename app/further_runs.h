#pragma once

#include "app/case_run.h"
#include "contact/model.h"

// What runs beside the models of a case find.

namespace tricontact::app {

/// Loads a model whose normal and tangential contact are coupled a few times more, on the
/// elasticity that `model` already has, and adds to `study`: what kinematics, coupling and the way
/// of pressing, one after another, change in the static shift; what the latter two change after
/// rolling; and the stiffness without friction, from presses at 0.6, 0.8 and 1 times the normal
/// load. `history` is that of the case's run with `model`; `say` hears of each. Models without such
/// choices add nothing.
///
/// Rolling is by turning points until nothing moves, also of what the variants are compared with;
/// where the run ratchets, in its own steps if these are few. Other kinematics are not rolled: the
/// displaced surface slips to and fro for ever and takes ten times as long.
void study_loading(const contact::Case& c, const contact::Model& model,
                   const contact::History& history, const Say& say,
                   comparisons::LoadingStudy& study);

/// Adds to `study` what the drive means for a relaxing case and, if `options` want studies, the
/// comparison of `history`, that of the case's run with a model, with an elastic reference run of
/// the substrate. The first model that comes here then also looks for the slowest drive speed at
/// which that errs by 1 % (find_speed_limit). Finite elements are too costly for either. Elastic
/// cases add nothing.
void study_relaxation(const contact::Case& c, const contact::History& history,
                      const RunOptions& options, const Say& say,
                      comparisons::RelaxationStudy& study);

}  // namespace tricontact::app

#pragma once

#include "app/models.h"
#include "comparisons/loading_study.h"
#include "contact/case.h"
#include "contact/history.h"
#include "contact/model.h"

namespace tricontact::app {

/// Loads a model whose normal and tangential contact are coupled a few times more, without rolling,
/// on the elasticity that `model` already has, and adds to `study`: what kinematics, coupling and
/// the way of pressing, one after another, change in the static shift; and the stiffness without
/// friction, from presses at 0.6, 0.8 and 1 times the normal load. `history` is that of the case's
/// run with `model`; `say` hears of each. Models without such choices add nothing.
void study_loading(const contact::Case& c, const contact::Model& model,
                   const contact::History& history, const Say& say,
                   comparisons::LoadingStudy& study);

}  // namespace tricontact::app

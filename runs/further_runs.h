#pragma once

#include <string>
#include <vector>

#include "comparisons/quantities/loading_study.h"
#include "comparisons/quantities/relaxation_study.h"
#include "comparisons/run/small_strains.h"
#include "contact/history.h"
#include "runs/options.h"

// What runs beside the models of a case find.
namespace tricontact::runs {

/// Adds to `study` the stiffness without friction and, unless the case prescribes its path or the
/// study goes without variants, loads a model whose normal and tangential contact are coupled a few
/// times more, on the elasticity that `model` already has: what coupling and the way of pressing,
/// one after another, change in the static shift and in that after rolling. `history` is that of
/// the case's run with `model`, which is used for nothing else behind it; `say` hears of each.
///
/// Rolling is by turning points until nothing moves, also of what the variants are compared with;
/// where the run ratchets, in its own steps if these are few.
void study_loading(const Case& c, contact::Model& model, const contact::History& history,
                   const Say& say, comparisons::LoadingStudy& study);

/// Adds to `study` what the drive means for a relaxing case and, if `options` want studies, the
/// comparison of `history`, that of the case's run with a model, with an elastic reference run of
/// the substrate. The first model that comes here then also looks for the slowest drive speed at
/// which that errs by 1 % (find_speed_limit). Finite elements are too costly for either. Elastic
/// cases add nothing.
void study_relaxation(const Case& c, const contact::History& history, const RunOptions& options,
                      const Say& say, comparisons::RelaxationStudy& study);

/// Adds to `studies` what small strains would change in the run of a model at finite ones: run once
/// more with a linear material, if `options` want studies. Other models add nothing.
void study_small_strains(const Case& c, const contact::History& history, const RunOptions& options,
                         const Say& say, std::vector<comparisons::SmallStrains>& studies);

}  // namespace tricontact::runs

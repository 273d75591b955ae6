#pragma once

#include <functional>

#include "contact/case.h"
#include "contact/history.h"
#include "contact/model.h"

namespace tricontact::contact {

/// Called after every step with the model in its new state: progress bars, file output.
struct Progress {
    int step = 0;           ///< steps done; 1 again: all before is void, the grid was too small
    int steps_at_most = 0;  ///< total if every period is run
    bool quarter =
        false;  ///< the indenter is upright or at a turning point, or rolling has not begun
};
using Observer = std::function<void(const StepRecord&, Model&, const Progress&)>;

/// Presses, loads and rolls until the contact has settled (see verdict.h) or the last period. A
/// contact that reaches the edge of its grid begins anew on a larger one. Throws NotConverged (also
/// when a solution fails its audit) and InputError.
History run(const Case& c, Model& model, const Observer& observer = {});

/// What ends a run of many periods in the place of the verdict; the history, not judged, is asked
/// for after each period. Surfaces are not kept.
using Enough = std::function<bool(const History&)>;
History run_until(const Case& c, Model& model, const Enough& enough, const Observer& observer);

}  // namespace tricontact::contact

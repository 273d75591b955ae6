#pragma once

#include <functional>
#include <optional>

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

/// Presses, loads and rolls until the contact has settled (see Judge; with rolling.until =
/// "settled": until it is known where it will stand or how fast it ratchets) or the last period. A
/// contact that reaches the edge of its grid begins again on a larger one. Throws NotConverged
/// (also when a solution fails its audit) and InputError.
///
/// With `negligible`: rolls until the series of periods, and not the limit, decides whether
/// increments of more than `negligible` U_max go on, or the last period; slip back and forth while
/// the shift stands counts as shakedown. Surfaces are not kept.
History run(const Case& c, Model& model, const Observer& observer = {},
            std::optional<double> negligible = {});

}  // namespace tricontact::contact

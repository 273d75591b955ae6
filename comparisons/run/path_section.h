#pragma once

#include <vector>

#include "comparisons/run/figures.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// The last step at each row of a prescribed path; null where a row was never a step's end: the
/// first one of a path that starts unloaded.
std::vector<const contact::StepRecord*> steps_at_rows(const contact::History& history);

/// What the models did along a prescribed path: values at its rows, and curves of all steps. Empty
/// heading without such a path.
/// What the twist, the shifts and the torque of a path are about, with lengths in mm.
std::string centre_of_rotation_text(const contact::Case& c);

report::DocumentSection path_section(const contact::Case& c, const Histories& histories);

}  // namespace tricontact::comparisons

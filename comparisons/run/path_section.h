#pragma once

#include <string>

#include "comparisons/run/figures.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// What the twist, the shifts and the torque of a path are about, with lengths in mm.
std::string centre_of_rotation_text(const contact::Case& c);

/// The sentence's beginning that tells the last closed cycle, ending with "friction works ".
std::string loop_words(const Results& results);

/// What the models did along a prescribed path: values at its rows, and curves of all steps. Empty
/// heading without such a path.
report::DocumentSection path_section(const contact::Case& c, const Histories& histories);

}  // namespace tricontact::comparisons

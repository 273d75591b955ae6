#pragma once

#include <string>
#include <vector>

#include "comparisons/quantities/results.h"
#include "contact/case.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// What a height map was taken for: layout, nodes, spacing, extent, relief; which node presses
/// first, and a warning where that lies on the border. Empty for other bodies. Sentences.
std::vector<std::string> map_sentences(const contact::Case& c);

/// What files of the case were taken for: the map, and the fit of a relaxation table. Plain
/// letters, for terminals.
std::vector<std::string> input_sentences(const contact::Case& c);

/// Whether contact stays off the border of the map; empty for other bodies.
std::vector<report::Verdict> border_verdicts(const contact::Case& c,
                                             const std::vector<Results>& results);
/// The same for terminals: only where it does not.
std::string border_warning(const Results& results);
/// Of many runs, how many of them reach it and the one that presses there most; none: empty.
std::string border_warning(const std::vector<const Results*>& runs);

}  // namespace tricontact::comparisons

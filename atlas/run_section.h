#pragma once

#include <optional>
#include <vector>

#include "comparisons/quantities/results.h"
#include "contact/case.h"
#include "report/document.h"

namespace tricontact::atlas {

/// Where a case lies in the shipped maps, for the report of its run: the settled shift, or that of
/// each period, over amplitude and load with the limit and the case, and what the maps say beside
/// what the models came to. Empty if no map is about the case, or if it does not roll.
std::optional<report::DocumentSection> place_in_maps(
    const contact::Case& c, const std::vector<comparisons::Results>& results);

}  // namespace tricontact::atlas

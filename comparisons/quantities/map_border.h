#pragma once

#include <optional>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// Of a height map without a period: the largest share of F_N in any of the states that were kept
/// which lies on cells at the map's border, beside which the body ends [-]. 0 where no contact
/// reaches the border; empty for other bodies and without kept states.
std::optional<double> border_force_share(const contact::Case& c, const contact::History& history);

/// Of one of these states.
double border_force_share(const contact::HeightMap& map, const contact::Surface& surface);

}  // namespace tricontact::comparisons

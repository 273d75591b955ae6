#pragma once

#include <vector>

#include "comparisons/half_space/half_space_deviation.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// Exact quantities over the thickness for the case's material: ratios, then deviations in percent
/// on logarithmic axes beside what boundary elements computed.
std::vector<report::Figure> thickness_figures(const HalfSpaceDeviation& deviation);

/// One quantity over the thickness for several nu and both bases.
std::vector<report::Figure> material_figures(const HalfSpaceDeviation& deviation);

/// Deviation of bonded layers over thickness and nu, one map per quantity.
std::vector<report::Figure> map_figures(const HalfSpaceDeviation& deviation);

/// Computed ratios over the thickness with their errors, one figure per quantity.
std::vector<report::Figure> rolled_figures(const HalfSpaceDeviation& deviation);

}  // namespace tricontact::comparisons

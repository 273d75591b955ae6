#pragma once

#include <string>
#include <vector>

#include "comparisons/walking/walk_map.h"

namespace tricontact::comparisons::walking {

/// What a page says about a machine of the map, in the order of map_reading_names.
std::vector<std::string> map_readings(const WalkMap& map, double kappa8,
                                      const dynamics::WalkResult& result);
const std::vector<std::string>& map_reading_names();

/// mu_c of the map's machine with this kappa8; its normal forces are those of its model.
double critical_friction(const WalkMap& map, double kappa8);

}  // namespace tricontact::comparisons::walking

#pragma once

#include <nlohmann/json.hpp>

#include "comparisons/walking/walk_map.h"

namespace tricontact::comparisons::walking {

/// What map_page.js draws: axes, quantities over them (null where a machine fell over), mu_c,
/// samples of each machine, normalised as in figures 4.5 and 4.6 of Wetter (2016) and packed, and
/// its readings as text.
nlohmann::ordered_json map_json(const WalkMap& map);

}  // namespace tricontact::comparisons::walking

#pragma once

#include <nlohmann/json_fwd.hpp>

#include "report/player.h"

namespace tricontact::report {

/// What player.js plays. Bytes as packed(), the mask eight cells to a byte, the lowest
/// bit first.
nlohmann::ordered_json player_json(const Player& player);

}  // namespace tricontact::report

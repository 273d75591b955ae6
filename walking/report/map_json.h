#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "walking/report/walk_map.h"

namespace tricontact::walking {

/// What map_page.js draws: axes, quantities over them (null where a machine fell over), mu_c,
/// samples of each machine, normalised as in figures 4.5 and 4.6 of Wetter (2016) and packed, and
/// its readings as text.
nlohmann::ordered_json map_json(const WalkMap& map);

/// What a page says about a machine of the map, in the order of map_reading_names.
std::vector<std::string> map_readings(const WalkMap& map, double kappa8, const WalkResult& result);
const std::vector<std::string>& map_reading_names();

/// mu_c of the map's machine with this kappa8; its normal forces are those of its model.
double critical_friction(const WalkMap& map, double kappa8);

/// Samples for a page that holds thousands of curves: value = offset + scale i, whole numbers i of
/// 16 bits in base64, little-endian. Off by at most scale/2: half of 1/65534 of what they span.
struct PackedSamples {
    double offset = 0, scale = 0;
    std::string base64;
};

/// Throws std::invalid_argument for a sample that is not finite.
PackedSamples packed(std::span<const float> samples);

}  // namespace tricontact::walking

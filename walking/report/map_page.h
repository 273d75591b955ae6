#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "walking/machine/machine.h"
#include "walking/study/walk_outcome.h"

namespace tricontact::walking {

/// Machines that differ in kappa8 and friction alone.
struct WalkMap {
    std::string title;
    Machine machine;  ///< of all; kappa5 and kappa8 are those of the cells instead
    std::vector<double> kappa8, friction;                            ///< increasing
    std::vector<WalkOutcome> cells;                                  ///< kappa8 fastest
    std::vector<std::pair<std::string, std::string>> settings = {};  ///< name, value with unit
    std::vector<std::pair<std::string, std::string>> files = {};     ///< text, path from the page
    std::string command = {};                                        ///< that makes it again
    std::string version = {};                                        ///< of the program
};

/// What map_page.js draws: axes, quantities over them (null where a machine fell over), mu_c,
/// samples of each machine, normalised as in figures 4.5 and 4.6 of Wetter (2016) and packed, and
/// its readings as text.
nlohmann::ordered_json map_json(const WalkMap& map);

/// Samples for a page that holds thousands of curves: value = offset + scale i, whole numbers i of
/// 16 bits in base64, little-endian. Off by at most scale/2: half of 1/65534 of what they span.
struct PackedSamples {
    double offset = 0, scale = 0;
    std::string base64;
};

/// Throws std::invalid_argument for a sample that is not finite.
PackedSamples packed(std::span<const float> samples);

/// One HTML file that needs no network: the map of kappa8 and friction with a marker that mouse,
/// finger and keyboard drag, beside it the motion of the machine under the marker as it was
/// computed and what its run came to. Same map, same bytes.
std::string map_page(const WalkMap& map);

}  // namespace tricontact::walking

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "contact/case.h"

namespace tricontact::atlas {

/// The shipped atlases as a page to explore.
struct AtlasPage {
    std::string title;
    std::string version;                  ///< of the program
    std::string command = {};             ///< that makes it again
    std::optional<contact::Case> c = {};  ///< where the marker stands at first
};

/// What atlas_page.js reads: the atlases as their files have them but for what only the program
/// needs, and the place of the case (atlas_maps.js); null if it lies beyond the map. Throws
/// contact::InputError if no atlas is about the case.
nlohmann::ordered_json atlas_page_json(const AtlasPage& page);

/// One HTML file that needs no network: maps over amplitude and load, sliders for the other
/// coordinates, and MDR, half-space and layer side by side at a marker. Throws as atlas_page_json.
std::string atlas_page(const AtlasPage& page);

}  // namespace tricontact::atlas

#pragma once

#include <string>

#include "walking/report/walk_map.h"

namespace tricontact::walking {

/// One HTML file that needs no network: the map of kappa8 and friction with a marker that mouse,
/// finger and keyboard drag, beside it the motion of the machine under the marker as it was
/// computed and what its run came to. Same map, same bytes. Throws std::invalid_argument for axes
/// that do not increase and for cells or samples that do not fit them.
std::string map_page(const WalkMap& map);

}  // namespace tricontact::walking

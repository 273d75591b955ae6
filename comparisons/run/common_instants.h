#pragma once

#include <array>
#include <string>
#include <vector>

#include "report/player.h"

namespace tricontact::comparisons {

/// The instants that all films have: one that lacks a part of the run altogether (never loaded) has
/// none there; one whose run ends with its first period has that as its last one, too.
std::vector<report::Player::Instant> common_instants(const std::vector<report::Film>& films);

/// The largest pressure, traction, gap and von Mises' stress of all films, in words.
std::array<std::string, 4> largest_of(const std::vector<report::Film>& films);

}  // namespace tricontact::comparisons

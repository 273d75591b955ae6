#pragma once

#include <span>
#include <string_view>

#include "atlas/atlas.h"

namespace tricontact::atlas {

/// The atlases of this program, from atlas/data, each parsed when it is first asked for. Throws
/// std::out_of_range for other names. From several threads at once too.
const Atlas& shipped(std::string_view name);

/// "sphere_half_space", ...: in alphabetical order.
std::span<const std::string_view> shipped_names();

/// Digest of all of them.
std::string_view shipped_digest();

}  // namespace tricontact::atlas

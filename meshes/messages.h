#pragma once

#include <string>
#include <string_view>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Throws contact::InputError `name: what; remedy` in one line.
[[noreturn]] void fail(std::string_view name, std::string_view what, std::string_view remedy);

/// A name out of a file, in quotes, at most 40 bytes long, without control characters.
std::string in_quotes(std::string_view text);

/// "(0.001, 0, -0.0025) m".
std::string place(const Point& point);

/// "contact, free_top, base, sides, symmetry".
std::string boundary_names();
/// "layer, lower_layer".
std::string region_names();

}  // namespace tricontact::meshes

#pragma once

#include <string>
#include <string_view>

#include "atlas/atlas.h"

namespace tricontact::atlas {

/// An atlas as JSON, its maps beside axes, study and provenance; the same atlas, the same bytes.
std::string write_atlas(const Atlas& atlas);

/// The text of such a file; `name` stands for it in messages. Throws contact::InputError if it is
/// none, was written for quantities or keys that this program has not, or does not fit its digest.
Atlas parse_atlas(std::string_view text, const std::string& name);
/// Throws contact::InputError, also if the file cannot be read.
Atlas read_atlas(const std::string& path);

}  // namespace tricontact::atlas

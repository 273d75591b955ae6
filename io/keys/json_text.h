#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace tricontact::io {

/// JSON from a file, whoever wrote it: a discarded value if it is none, nests deeper than
/// `most_levels`, has an object of more than `most_members`, or a number beyond those of double.
/// What works through a document calls itself for each level, and an ordered object is searched
/// from its front for each member: without bounds a text ends the program, or never ends.
nlohmann::ordered_json parsed_json(std::string_view text);

inline constexpr int most_levels = 64;
inline constexpr int most_members = 4096;

/// Whether a text is JSON within those bounds.
bool is_sound_json(std::string_view text);

}  // namespace tricontact::io

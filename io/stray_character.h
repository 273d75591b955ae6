#pragma once

#include <string_view>

namespace tricontact::io {

/// Offset of the first byte that is not ASCII and stands outside the strings and comments of a TOML
/// text or behind a backslash, npos if there is none. toml++ 3.3 must not see such characters: its
/// test for white space has undefined behaviour at U+00A1 to U+0499 and in other ranges.
std::string_view::size_type stray_character(std::string_view toml);

}  // namespace tricontact::io

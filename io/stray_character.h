#pragma once

#include <string_view>

namespace tricontact::io {

/// Offset of the first byte that is not ASCII and stands outside the strings and comments of a TOML
/// text, npos if there is none. TOML has no such characters, and toml++ 3.3 must not see them: its
/// test for white space has undefined behaviour between U+00A1 and U+0499.
std::string_view::size_type stray_character(std::string_view toml);

}  // namespace tricontact::io

#pragma once

#include <string>
#include <string_view>

namespace tricontact::io {

/// Moves every character from U+0080 to U+FEFF to the unassigned plane 4, U+40080 to U+4FEFF. The
/// test for white space of toml++ 3.3 has undefined behaviour at U+00A1 to U+0499 and in other
/// ranges wherever it meets such a character outside a string; above U+FEFF it is sound. One
/// character stays one character, so that columns are right. A byte order mark in front stays.
std::string escape_non_ascii(std::string_view text);
/// Gives the characters back that `escape_non_ascii` moved.
std::string restore_non_ascii(std::string_view text);

/// Where a TOML text nests deeper than sixteen parts of a dotted key or the name of a section, or
/// than thirty-two lists and tables in braces; npos if it does so nowhere. Says nothing of whether
/// the text is TOML, but looks at all that a parser would read before it finds that it is not.
std::string_view::size_type first_too_deep(std::string_view text);

}  // namespace tricontact::io

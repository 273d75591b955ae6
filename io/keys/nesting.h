#pragma once

#include <string_view>

namespace tricontact::io {

/// Where a TOML text nests deeper than sixteen parts of a dotted key or the name of a section, or
/// than thirty-two lists and tables in braces; npos if it does so nowhere. Says nothing of whether
/// the text is TOML, but looks at all that a parser would read before it finds that it is not.
std::string_view::size_type first_too_deep(std::string_view text);

}  // namespace tricontact::io

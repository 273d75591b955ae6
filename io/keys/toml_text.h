#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tricontact::io {

/// Exchanges every character beyond ASCII for one of the private-use characters U+F0000 ... and
/// back. The test for white space of toml++ 3.3 has undefined behaviour at U+00A1 to U+0499 and in
/// other ranges wherever it meets such a character outside a string; above U+FEFF it is sound. One
/// character stays one character, so that columns are right.
class NonAsciiEscaper {
  public:
    /// `text` must be UTF-8; a byte order mark in front stays. Throws std::length_error if the
    /// texts so far have more than 65000 different characters beyond ASCII.
    std::string escaped(std::string_view text);
    /// Gives the characters back that earlier calls of `escaped` exchanged.
    std::string restored(std::string_view text) const;

  private:
    std::vector<std::string> characters_;  // the k-th went to U+F0000 + k
};

/// Where a TOML text nests deeper than sixteen parts of a dotted key or the name of a section, or
/// than thirty-two lists and tables in braces; npos if it does so nowhere. Says nothing of whether
/// the text is TOML, but looks at all that a parser would read before it finds that it is not.
std::string_view::size_type first_too_deep(std::string_view text);

}  // namespace tricontact::io

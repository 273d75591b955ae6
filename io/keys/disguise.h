#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tricontact::io {

/// Exchanges every character beyond ASCII for one of the private-use characters U+F0000 ... and
/// back. The test for white space of toml++ 3.3 has undefined behaviour at U+00A1 to U+0499 and in
/// other ranges wherever it meets such a character outside a string; above U+FEFF it is sound. One
/// character stays one character, so that columns are right.
class Disguise {
  public:
    /// `text` must be UTF-8; a byte order mark in front stays. Throws std::length_error if the
    /// texts so far have more than 65000 different characters beyond ASCII.
    std::string put_on(std::string_view text);
    /// Gives the characters back that earlier calls of `put_on` exchanged.
    std::string take_off(std::string_view text) const;

  private:
    std::vector<std::string> characters_;  // the k-th went to U+F0000 + k
};

}  // namespace tricontact::io

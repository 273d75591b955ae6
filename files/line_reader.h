#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "files/regular_file.h"

namespace tricontact::files {

/// The lines of a regular file that may be too large to be held as a whole. Members throw
/// Unreadable.
class LineReader {
  public:
    explicit LineReader(const std::string& path) : file_(path) {}

    /// The next line without its end; false after the last one. Throws also if it is longer than
    /// `longest` bytes.
    bool next(std::string& line, std::size_t longest = 1'000'000);

  private:
    bool fill();

    RegularFile file_;
    std::array<char, 65536> buffer_{};
    std::size_t begin_ = 0, end_ = 0;  // of what has not been given yet
};

}  // namespace tricontact::files

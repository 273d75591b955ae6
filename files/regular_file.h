#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace tricontact::files {

/// Why a file cannot be read, to follow its name: "is a directory", "is not a regular file",
/// "cannot be read (Permission denied)".
class Unreadable : public std::runtime_error {
  public:
    /// The file's kind or size is to blame.
    explicit Unreadable(const std::string& why) : std::runtime_error(why) {}
    /// The system refuses, with this errno.
    explicit Unreadable(int error);
    int error() const { return error_; }  ///< errno, or 0

  private:
    int error_ = 0;
};

/// A regular file open for reading. Whatever a name leads to, opening and reading never wait: named
/// pipes, devices and directories are refused, and so are files of /proc that wait for news. All
/// that is read by a name which the user gave, or from a folder of the user's, is read by this
/// class. Members throw Unreadable.
class RegularFile {
  public:
    explicit RegularFile(const std::string& path);
    ~RegularFile();
    RegularFile(const RegularFile&) = delete;
    RegularFile& operator=(const RegularFile&) = delete;

    int descriptor() const { return descriptor_; }
    std::uint64_t size() const { return size_; }  ///< [bytes], when it was opened
    /// Up to n bytes from where the last call ended; 0 at the end.
    std::size_t read(void* bytes, std::size_t n);
    /// All that is left. Throws also if that is more than `most` bytes.
    std::string content(std::uint64_t most);

  private:
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

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

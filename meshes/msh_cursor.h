#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "meshes/msh_file.h"

namespace tricontact::meshes {

/// Numbers of a gmsh file, one after the other, text or raw bytes. Nothing is believed that the
/// bytes do not hold. Members throw contact::InputError that names the line, or the byte.
class MshCursor {
  public:
    /// On `part` of the file's bytes.
    MshCursor(const MshFile& file, std::string_view part, bool binary);
    MshCursor(const MshFile& file, std::string_view part) : MshCursor(file, part, file.binary) {}

    /// int, std::size_t or double; `what` is its name in messages.
    template <class Number>
    Number next(const char* what);
    /// How many of `what` follow, in bytes that are there: each takes one at least.
    std::size_t next_count(const char* what);
    /// What is left of a line of text.
    std::string_view rest_of_line();
    /// What follows this line, as raw bytes if the file is binary.
    MshCursor after_line() const;
    /// Throws unless nothing but blanks follows.
    void expect_end(const char* what) const;

    [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const;

  private:
    const MshFile& file_;
    std::string_view rest_;
    bool binary_;
};

}  // namespace tricontact::meshes

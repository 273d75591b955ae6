#pragma once

#include <string>
#include <string_view>

namespace tricontact::io {

/// Writes `bytes` to `path` at once or not at all: a temporary beside it, fsync, rename.
/// Throws contact::InputError naming the path, the system's reason and a remedy.
void write_file(const std::string& path, std::string_view bytes);

/// Makes the folder (with parents) if it is missing and proves that a file can be written there.
/// Throws contact::InputError if it is a file, or cannot be made or written to.
void make_output_folder(const std::string& path);

}  // namespace tricontact::io

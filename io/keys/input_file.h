#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tricontact::io {

/// Text of a regular file of at most `most_mb` megabytes. Throws contact::InputError naming path,
/// reason, remedy; `kind` is what the file should be.
std::string read_input_file(const std::string& path, std::string_view kind = "case file",
                            std::size_t most_mb = 1);

/// Remembers a file that something else reads as an input of this process (read_input_file does so
/// by itself): no output replaces it.
void note_input_file(const std::string& path);

/// Whether the process has read it as an input, by whatever path.
bool is_input_file(const std::string& path);

}  // namespace tricontact::io

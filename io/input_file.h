#pragma once

#include <string>

namespace tricontact::io {

/// Text of a regular file of at most 1 MB. Throws contact::InputError naming path, reason, remedy.
std::string read_input_file(const std::string& path);

}  // namespace tricontact::io

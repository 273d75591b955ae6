#pragma once

#include <string>
#include <string_view>

namespace tricontact::io {

/// Throws contact::InputError with the system's reason for `error` (an errno) and a remedy.
[[noreturn]] void refuse_output(const std::string& path, const char* what, int error);

/// Refuses a place at which a file must not be put: where a link, a device, a named pipe, a socket
/// or a folder stands, or a file that this process has read as an input (is_input_file).
void check_replaceable(const std::string& path);

/// Before anything is computed for a file that the user names: as check_replaceable; and where a
/// file stands already it must begin as those that this program writes do, or be empty. Refuses
/// also a folder that is missing or in which nobody may write.
void check_output_file(const std::string& path, std::string_view beginning);

/// Refuses a folder that cannot be made, or in which nobody may write. Nothing is touched.
void check_output_place(const std::string& path);

}  // namespace tricontact::io

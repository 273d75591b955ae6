#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tricontact::io {

/// Writes `bytes` to `path` at once or not at all: a temporary beside it, fsync, rename. Refuses
/// what check_replaceable (output_target.h) does. Throws contact::InputError naming the path, the
/// system's reason and a remedy.
void write_file(const std::string& path, std::string_view bytes);

/// Makes the folder (with parents) if it is missing and proves that a file can be written there.
/// Throws contact::InputError if it is a file, or cannot be made or written to.
void make_output_folder(const std::string& path);

/// Where a command writes: the folder `given`, or results/<name of the input file><suffix>.
std::string output_folder(const std::string& given, const std::string& input_file,
                          const std::string& suffix = {});

/// Removes files of the folder, by names relative to it: what an earlier run left must not stand
/// beside a new case as if it were its own. One that cannot be removed cannot be written either,
/// which is said then.
void remove_old_results(const std::string& folder, const std::vector<std::string>& names);

}  // namespace tricontact::io

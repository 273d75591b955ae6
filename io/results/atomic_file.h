#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tricontact::io {

/// Writes `bytes` to `path` at once or not at all: a temporary beside it, fsync, rename. Refuses
/// what check_replaceable (output_target.h) does. Throws contact::InputError naming the path, the
/// system's reason and a remedy.
void write_file(const std::string& path, std::string_view bytes);
/// The same of pieces one after another but for the fsync, for files of a series: whole whenever
/// the process ends, but on the disk after `sync_files` of their folder only. Both throw
/// contact::InputError.
void write_unsynced(const std::string& path, std::span<const std::string_view> pieces);
void sync_files(const std::string& folder);

/// Removes a file that is to be written anew. Refuses what check_replaceable does; throws
/// contact::InputError also if it stays.
void remove_file(const std::string& path);

/// Makes the folder (with parents) if it is missing and proves that a file can be written there.
/// Throws contact::InputError if it is a file, or cannot be made or written to.
void make_output_folder(const std::string& path);

/// Where a command writes: the folder `given`, or results/<name of the input file><suffix>.
std::string output_folder(const std::string& given, const std::string& input_file,
                          const std::string& suffix = {});

/// Removes files of the folder, by names relative to it, of a folder among them ("plots/") the
/// files of figures (one name with .svg, .png, .csv), with a series (`.ex2`) what earlier versions
/// wrote of it (former_series.h): what an earlier run left must not stand
/// beside a new case as if it were its own. One that cannot be removed cannot be written either,
/// which is said then.
void remove_old_results(const std::string& folder, const std::vector<std::string>& names);

/// Up to n bytes from the beginning of a file; none if it cannot be read.
std::string first_bytes(const std::string& path, std::size_t n);

/// Throws contact::InputError with the system's reason for `error` (an errno) and a remedy.
[[noreturn]] void refuse_output(const std::string& path, const char* what, int error);

/// Refuses a place at which a file must not be put: where a link, a device, a named pipe, a socket
/// or a folder stands, or a file that this process has read as an input (is_input_file). Whether a
/// file stands there.
bool check_replaceable(const std::string& path);

/// Before anything is computed for a file that the user names: as check_replaceable; and where a
/// file stands already it must begin as those that this program writes do, or be empty. Refuses
/// also a folder that is missing or in which writing is not allowed.
void check_output_file(const std::string& path, std::string_view beginning);

/// Refuses a folder that cannot be made, or in which writing is not allowed. Nothing is touched.
void check_output_place(const std::string& path);

}  // namespace tricontact::io

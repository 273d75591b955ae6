#include "io/results/atomic_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "files/partial_file.h"
#include "io/keys/messages.h"
#include "io/results/output_target.h"

namespace tricontact::io {

namespace {

namespace fs = std::filesystem;

// Writes the file; `blamed` and `what` begin the message of any failure: "<blamed>: <what> (Disk
// full)".
void write_or_refuse(const std::string& path, std::string_view bytes, const std::string& blamed,
                     const char* what, bool keep) {
    try {
        files::PartialFile file(path);
        file.write(bytes);
        if (keep) file.move_to_target();
    } catch (const std::system_error& error) {
        refuse_output(blamed, what, error.code().value());
    }
}

}  // namespace

void write_file(const std::string& path, std::string_view bytes) {
    if (fs::path(path).filename().empty())
        fail(path, "", "names no file to write", "add a file name");
    check_replaceable(path);
    write_or_refuse(path, bytes, path, "cannot be written", true);
}

void make_output_folder(const std::string& path) {
    check_output_place(path);
    std::error_code error;
    fs::create_directories(path, error);
    if (error) refuse_output(path, "the output folder cannot be made", error.value());
    files::remove_left_partial_files(path);
    // Proves the right to write, and leaves nothing behind.
    write_or_refuse((fs::path(path) / "probe").string(), "probe", path,
                    "the output folder cannot be written to", false);
}

std::string output_folder(const std::string& given, const std::string& input_file,
                          const std::string& suffix) {
    return given.empty() ? "results/" + fs::path(input_file).stem().string() + suffix : given;
}

void remove_old_results(const std::string& folder, const std::vector<std::string>& names) {
    std::error_code ignored;
    for (const std::string& name : names) fs::remove(fs::path(folder) / name, ignored);
}

}  // namespace tricontact::io

#include "io/results/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "files/partial_file.h"
#include "io/keys/input_file.h"
#include "io/keys/messages.h"
#include "io/results/former_series.h"

namespace tricontact::io {

namespace {

namespace fs = std::filesystem;

enum class Kept { no, unsynced, synced };

// Writes the file; `blamed` and `what` begin the message of any failure: "<blamed>: <what> (Disk
// full)".
void write_or_refuse(const std::string& path, std::span<const std::string_view> pieces,
                     const std::string& blamed, const char* what, Kept kept) {
    try {
        files::PartialFile file(path);
        files::write_all(file.descriptor(), 0, pieces);
        if (kept != Kept::no) file.move_to_target(kept == Kept::synced);
    } catch (const std::system_error& error) {
        refuse_output(blamed, what, error.code().value());
    }
}

const char* kind_of(fs::file_type type) {
    using enum fs::file_type;
    return type == symlink  ? "is a link, and nothing is written through links"
           : type == fifo   ? "is a named pipe, not a regular file"
           : type == socket ? "is a socket, not a regular file"
                            : "is a device, not a regular file";
}

void write_checked(const std::string& path, std::span<const std::string_view> pieces, Kept kept) {
    if (fs::path(path).filename().empty())
        fail(path, "", "names no file to write", "add a file name");
    check_replaceable(path);
    write_or_refuse(path, pieces, path, "cannot be written", kept);
}

// The drawing goes last: a removal that is interrupted is made up for.
void remove_figures(const fs::path& folder) {
    std::error_code ignored;
    std::vector<fs::path> drawings;
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".svg") drawings.push_back(entry.path());
    for (fs::path file : drawings)
        for (const char* extension : {".csv", ".png", ".svg"})
            fs::remove(file.replace_extension(extension), ignored);
}

}  // namespace

std::string first_bytes(const std::string& path, std::size_t n) {
    std::ifstream file(path, std::ios::binary);
    std::string found(n, '\0');
    file.read(found.data(), static_cast<std::streamsize>(n));
    found.resize(static_cast<std::size_t>(file.gcount()));
    return found;
}

void write_file(const std::string& path, std::string_view bytes) {
    write_checked(path, {&bytes, 1}, Kept::synced);
}

void write_unsynced(const std::string& path, std::span<const std::string_view> pieces) {
    write_checked(path, pieces, Kept::unsynced);
}

void remove_file(const std::string& path) {
    check_replaceable(path);
    std::error_code error;
    fs::remove(path, error);
    if (error) refuse_output(path, "cannot be replaced", error.value());
}

void sync_files(const std::string& folder) {
    try {
        files::sync_file_system(folder);
    } catch (const std::system_error& error) {
        refuse_output(folder, "files cannot be written", error.code().value());
    }
}

void make_output_folder(const std::string& path) {
    check_output_place(path);
    std::error_code error;
    fs::create_directories(path, error);
    if (error) refuse_output(path, "the output folder cannot be made", error.value());
    files::remove_left_partial_files(path);
    // Proves the right to write, and leaves nothing behind.
    constexpr std::string_view probe = "probe";
    write_or_refuse((fs::path(path) / "probe").string(), {&probe, 1}, path,
                    "the output folder cannot be written to", Kept::no);
}

std::string output_folder(const std::string& given, const std::string& input_file,
                          const std::string& suffix) {
    return given.empty() ? "results/" + fs::path(input_file).stem().string() + suffix : given;
}

void remove_old_results(const std::string& folder, const std::vector<std::string>& names) {
    std::error_code ignored;
    for (const std::string& name : names) {
        const fs::path path = fs::path(folder) / name;
        if (name.ends_with('/'))
            remove_figures(path);
        else
            fs::remove(path, ignored);
        if (path.extension() == ".ex2")
            remove_former_series(path.parent_path().string(), path.stem().string());
    }
}

void refuse_output(const std::string& path, const char* what, int error) {
    const char* remedy = "choose another output folder";
    if (error == ENOSPC || error == EDQUOT || error == EFBIG)
        remedy = "free space on the disk, or choose another output folder";
    if (error == EACCES || error == EPERM || error == EROFS)
        remedy = "choose an output folder in which you may write";
    if (error == ENOENT) remedy = "make the folder first";
    fail(path, "", std::string(what) + " (" + std::generic_category().message(error) + ")", remedy);
}

bool check_replaceable(const std::string& path) {
    std::error_code ignored;
    const fs::file_type type = fs::symlink_status(path, ignored).type();
    if (type == fs::file_type::not_found || type == fs::file_type::none) return false;
    if (type == fs::file_type::directory) refuse_output(path, "cannot be written", EISDIR);
    if (type != fs::file_type::regular)
        fail(path, "", kind_of(type), "remove it, or choose another place for the output");
    if (is_input_file(path))
        fail(path, "", "is an input of this command, which it would replace",
             "choose another place for the output");
    return true;
}

void check_output_file(const std::string& path, std::string_view beginning) {
    const fs::path file(path);
    if (file.filename().empty()) fail(path, "", "names no file to write", "add a file name");
    check_replaceable(path);
    std::error_code error;
    const std::string found = first_bytes(path, beginning.size());
    if (!found.empty() && found != beginning)
        fail(path, "", "is there already, and tricontact did not write it",
             "remove it, or choose another name");
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::exists(folder, error)) refuse_output(path, "cannot be written", ENOENT);
    if (!fs::is_directory(folder, error)) refuse_output(path, "cannot be written", ENOTDIR);
    if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
        refuse_output(path, "cannot be written", errno);
}

void check_output_place(const std::string& path) {
    if (path.empty()) fail("output folder", "", "has no name", "name a folder");
    std::error_code error;
    if (fs::exists(path, error) && !fs::is_directory(path, error))
        fail(path, "", "is a file, not an output folder", "name a folder, or remove the file");
    fs::path there = fs::absolute(path).lexically_normal();
    while (!fs::exists(fs::symlink_status(there, error)) && there.has_relative_path())
        there = there.parent_path();
    if (!fs::exists(there, error))
        fail(there.string(), "", "is a link that leads nowhere",
             "remove it, or choose another output folder");
    if (!fs::is_directory(there, error))
        refuse_output(path, "the output folder cannot be made", ENOTDIR);
    if (::faccessat(AT_FDCWD, there.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
        refuse_output(path,
                      fs::exists(path, error) ? "the output folder cannot be written to"
                                              : "the output folder cannot be made",
                      errno);
}

}  // namespace tricontact::io

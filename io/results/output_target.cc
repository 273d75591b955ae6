#include "io/results/output_target.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "io/keys/input_file.h"
#include "io/keys/messages.h"

namespace tricontact::io {

namespace {

namespace fs = std::filesystem;

const char* kind_of(fs::file_type type) {
    switch (type) {
        case fs::file_type::symlink:
            return "is a link, and nothing is written through links";
        case fs::file_type::fifo:
            return "is a named pipe, not a regular file";
        case fs::file_type::socket:
            return "is a socket, not a regular file";
        default:
            return "is a device, not a regular file";
    }
}

bool begins_with(const std::string& path, std::string_view beginning) {
    std::ifstream file(path, std::ios::binary);
    std::string found(beginning.size(), '\0');
    file.read(found.data(), static_cast<std::streamsize>(found.size()));
    found.resize(static_cast<std::size_t>(file.gcount()));
    return found.empty() || found == beginning;
}

}  // namespace

void refuse_output(const std::string& path, const char* what, int error) {
    const char* remedy = "choose another output folder";
    if (error == ENOSPC || error == EDQUOT || error == EFBIG)
        remedy = "free space on the disk, or choose another output folder";
    if (error == EACCES || error == EPERM || error == EROFS)
        remedy = "choose an output folder in which you may write";
    if (error == ENOENT) remedy = "make the folder first";
    fail(path, "", std::string(what) + " (" + std::generic_category().message(error) + ")", remedy);
}

void check_replaceable(const std::string& path) {
    std::error_code ignored;
    const fs::file_type type = fs::symlink_status(path, ignored).type();
    if (type == fs::file_type::not_found || type == fs::file_type::none) return;
    if (type == fs::file_type::directory) refuse_output(path, "cannot be written", EISDIR);
    if (type != fs::file_type::regular)
        fail(path, "", kind_of(type), "remove it, or choose another place for the output");
    if (is_input_file(path))
        fail(path, "", "is an input of this command, which it would replace",
             "choose another place for the output");
}

void check_output_file(const std::string& path, std::string_view beginning) {
    const fs::path file(path);
    if (file.filename().empty()) fail(path, "", "names no file to write", "add a file name");
    check_replaceable(path);
    std::error_code error;
    if (fs::exists(path, error) && !begins_with(path, beginning))
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

#include "io/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "io/messages.h"

namespace tricontact::io {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const char* what, int error) {
    const char* remedy = "choose another output folder";
    if (error == ENOSPC || error == EDQUOT || error == EFBIG)
        remedy = "free space on the disk, or choose another output folder";
    if (error == EACCES || error == EPERM || error == EROFS)
        remedy = "choose an output folder in which you may write";
    if (error == ENOENT) remedy = "make the folder first";
    fail(path, "", std::string(what) + " (" + std::generic_category().message(error) + ")", remedy);
}

// A file that is removed again unless it has been moved to its final name.
class TemporaryFile {
  public:
    // `what` and `blamed` begin the message of any failure: "<blamed>: <what> (Disk full)".
    TemporaryFile(const fs::path& target, std::string blamed, const char* what)
        : target_(target.string()), blamed_(std::move(blamed)), what_(what) {
        static std::atomic<unsigned> counter = 0;
        std::string name = ".";
        name.append(target.filename().string()).append(".partial-");
        name.append(std::to_string(::getpid())).append("-").append(std::to_string(counter++));
        path_ = (target.parent_path() / name).string();
        // 0666 less the umask: the mode of any new file.
        fd_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd_ < 0) refuse(blamed_, what_, errno);
    }
    ~TemporaryFile() {
        if (fd_ >= 0) ::close(fd_);
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    void write(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) refuse(blamed_, what_, errno);
            bytes.remove_prefix(static_cast<std::size_t>(n));
        }
    }

    void move_to_target() {
        if (::fsync(fd_) != 0) refuse(blamed_, what_, errno);
        const int fd = std::exchange(fd_, -1);
        if (::close(fd) != 0) refuse(blamed_, what_, errno);
        if (std::rename(path_.c_str(), target_.c_str()) != 0) refuse(blamed_, what_, errno);
        path_.clear();
    }

  private:
    std::string target_, blamed_, path_;
    const char* what_;
    int fd_ = -1;
};

}  // namespace

void write_file(const std::string& path, std::string_view bytes) {
    if (fs::path(path).filename().empty())
        fail(path, "", "names no file to write", "add a file name");
    TemporaryFile file(path, path, "cannot be written");
    file.write(bytes);
    file.move_to_target();
}

void make_output_folder(const std::string& path) {
    if (path.empty()) fail("output folder", "", "has no name", "name a folder");
    std::error_code error;
    if (fs::exists(path, error) && !fs::is_directory(path, error))
        fail(path, "", "is a file, not an output folder", "name a folder, or remove the file");
    fs::create_directories(path, error);
    if (error) refuse(path, "the output folder cannot be made", error.value());
    // Proves the right to write; the destructor leaves nothing behind.
    TemporaryFile probe(fs::path(path) / "probe", path, "the output folder cannot be written to");
    probe.write("probe");
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

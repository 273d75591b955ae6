#include "files/partial_file.h"

#include <fcntl.h>
#include <limits.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

namespace tricontact::files {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view mark = ".partial-";  // and a number, and perhaps an ending
constexpr int most_writers = 100;               // of one target at once

[[noreturn]] void fail(int error) {
    throw std::system_error(error, std::generic_category());
}

std::string path_of(const std::string& target, int number, const std::string& ending) {
    const fs::path path(target);
    std::string name = '.' + path.filename().string();
    name.append(mark).append(std::to_string(number)).append(ending);
    return (path.parent_path() / name).string();
}

bool is_partial(std::string_view name) {
    const auto at = name.rfind(mark);
    if (name.empty() || name.front() != '.' || at == name.npos || at == 0) return false;
    const std::string_view rest = name.substr(at + mark.size());
    const auto n_digits = rest.find_first_not_of("0123456789");
    return !rest.empty() && n_digits != 0 && (n_digits == rest.npos || rest[n_digits] == '.');
}

bool is_old(const struct stat& status) {
    constexpr std::time_t day = 86400;
    return std::time(nullptr) - status.st_mtime > day;
}

// Whether no process writes it. Only who has the lock of a file removes it, so the lock is taken
// first, and then the name has to lead to that file still.
bool is_left(int descriptor, const std::string& path) {
    const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    if (!locked && errno == EWOULDBLOCK) return false;
    struct stat status {
    }, named{};
    return ::fstat(descriptor, &status) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           S_ISREG(status.st_mode) && status.st_dev == named.st_dev &&
           status.st_ino == named.st_ino && (locked || is_old(status));
}

// False if somebody writes it, or it cannot be removed.
bool remove_left(const std::string& path) {
    const int descriptor = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) return errno == ENOENT;
    const bool removed = is_left(descriptor, path) && ::unlink(path.c_str()) == 0;
    ::close(descriptor);
    return removed;
}

// Whether the file that just got its temporary name is locked and still there: in between somebody
// may have taken it for one that was left. Where there are no locks, it is.
bool keep(int descriptor) {
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 && status.st_nlink == 1;
}

}  // namespace

PartialFile::PartialFile(std::string target, const std::string& ending)
    : target_(std::move(target)) {
    int number = 0;
    while (descriptor_ < 0) {
        path_ = path_of(target_, number, ending);
        // 0666 less the umask: the mode of any new file.
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ >= 0 && !keep(descriptor_))
            ::close(std::exchange(descriptor_, -1));
        else if (descriptor_ < 0 && (errno != EEXIST || number == most_writers))
            fail(errno);
        if (descriptor_ < 0 && !remove_left(path_)) ++number;
    }
    is_first_ = number == 0;
}

PartialFile::~PartialFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
    if (descriptor_ >= 0) ::close(descriptor_);
}

void PartialFile::write(std::string_view bytes) {
    write_all(descriptor_, bytes);
}

void write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail(errno);
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
}

std::uint64_t write_all(int descriptor, std::uint64_t at,
                        std::span<const std::string_view> pieces) {
    std::vector<iovec> rest;
    rest.reserve(pieces.size());
    for (const std::string_view piece : pieces)
        if (!piece.empty()) rest.push_back({const_cast<char*>(piece.data()), piece.size()});
    for (std::size_t i = 0; i < rest.size();) {
        const std::size_t most = std::min<std::size_t>(rest.size() - i, IOV_MAX);
        const auto n =
            ::pwritev(descriptor, &rest[i], static_cast<int>(most), static_cast<off_t>(at));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail(errno);
        at += static_cast<std::uint64_t>(n);
        auto written = static_cast<std::size_t>(n);
        for (; i < rest.size() && written >= rest[i].iov_len; ++i) written -= rest[i].iov_len;
        if (written == 0) continue;
        rest[i].iov_base = static_cast<char*>(rest[i].iov_base) + written;
        rest[i].iov_len -= written;
    }
    return at;
}

// The lock goes with the descriptor, so the file has its final name before it is closed.
void PartialFile::move_to_target(bool synced) {
    if (synced && ::fsync(descriptor_) != 0) fail(errno);
    if (std::rename(path_.c_str(), target_.c_str()) != 0) fail(errno);
    path_.clear();
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
}

bool wait_for_first_writer(const std::string& target) {
    const int descriptor =
        ::open(path_of(target, 0, {}).c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) return errno == ENOENT;
    int error = EINTR;
    while (error == EINTR) error = ::flock(descriptor, LOCK_SH) == 0 ? 0 : errno;
    ::close(descriptor);
    return error == 0;
}

void sync_file_system(const std::string& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) fail(errno);
    const int error = ::syncfs(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    if (error != 0) fail(error);
}

void remove_left_partial_files(const std::string& folder) noexcept {
    try {
        std::error_code error;
        for (fs::directory_iterator it(folder, error), end; !error && it != end;
             it.increment(error))
            if (is_partial(it->path().filename().string())) remove_left(it->path().string());
    } catch (...) {  // out of memory: they stay
    }
}

}  // namespace tricontact::files

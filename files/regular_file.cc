#include "files/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace tricontact::files {

constexpr const char* not_regular = "is not a regular file";

Unreadable::Unreadable(int error)
    : std::runtime_error("cannot be read (" + std::generic_category().message(error) + ")"),
      error_(error) {}

// O_NONBLOCK: opening a named pipe must not wait for its writer, reading /proc/kmsg not for the
// kernel. It changes nothing for files on disks.
RegularFile::RegularFile(const std::string& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
    if (descriptor_ < 0) {
        if (errno == ENXIO || errno == ENODEV) throw Unreadable(not_regular);  // socket, no device
        throw Unreadable(errno);
    }
    struct stat status {};
    const int error = ::fstat(descriptor_, &status) == 0 ? 0 : errno;
    if (error == 0 && S_ISREG(status.st_mode)) {
        size_ = static_cast<std::uint64_t>(std::max<off_t>(0, status.st_size));
        return;
    }
    ::close(descriptor_);
    if (error != 0) throw Unreadable(error);
    throw Unreadable(S_ISDIR(status.st_mode) ? "is a directory" : not_regular);
}

RegularFile::~RegularFile() {
    ::close(descriptor_);
}

std::size_t RegularFile::read(void* bytes, std::size_t n) {
    while (true) {
        const ssize_t got = ::read(descriptor_, bytes, n);
        if (got >= 0) return static_cast<std::size_t>(got);
        if (errno == EAGAIN) throw Unreadable(not_regular);
        if (errno != EINTR) throw Unreadable(errno);
    }
}

std::string RegularFile::content(std::uint64_t most) {
    std::string text;
    if (size_ <= most) text.reserve(size_);
    std::array<char, 65536> buffer{};
    while (size_ <= most) {
        const std::size_t n = read(buffer.data(), buffer.size());
        if (n == 0) return text;
        text.append(buffer.data(), n);
        if (text.size() > most) break;
    }
    throw Unreadable("is larger than " + std::to_string(most / 1'000'000) + " MB");
}

bool LineReader::fill() {
    begin_ = 0;
    end_ = file_.read(buffer_.data(), buffer_.size());
    return end_ > 0;
}

bool LineReader::next(std::string& line, std::size_t longest) {
    line.clear();
    bool any = false;
    while (begin_ < end_ || fill()) {
        any = true;
        const char* const from = buffer_.data() + begin_;
        const char* const to = buffer_.data() + end_;
        const char* const at = std::find(from, to, '\n');
        line.append(from, at);
        begin_ = static_cast<std::size_t>(at - buffer_.data()) + (at != to);
        if (line.size() > longest)
            throw Unreadable("has a line of more than " + std::to_string(longest) + " bytes");
        if (at != to) return true;
    }
    return any;
}

}  // namespace tricontact::files

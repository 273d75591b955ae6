#include "io/results/journal_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "io/keys/messages.h"
#include "io/results/atomic_file.h"

namespace tricontact::io {

namespace {

// Followed by the sizes of content and the content; numbers in the machine's own byte order: a
// journal stays where it was written.
constexpr std::string_view magic = "tricontact journal 1\n";

[[noreturn]] void fail_by_system(int error, const std::string& path) {
    throw std::system_error(error, std::generic_category(), path);
}

// Fowler, Noll and Vo's FNV-1a over words of 8 bytes, the last one filled up with zeros: enough
// against truncation and damage, which are accidents.
std::uint64_t checksum(std::uint64_t hash, std::string_view bytes) {
    constexpr std::uint64_t prime = 0x100000001b3;
    for (std::size_t i = 0; i < bytes.size(); i += sizeof hash) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
        hash = (hash ^ word) * prime;
        hash ^= hash >> 32;  // high bits of a word must reach the low ones
    }
    return (hash ^ bytes.size()) * prime;
}

constexpr std::uint64_t first_checksum = 0xcbf29ce484222325;

std::string bytes_of(std::uint64_t number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    return bytes;
}

std::uint64_t number_of(std::string_view bytes) {
    std::uint64_t number = 0;
    std::memcpy(&number, bytes.data(), sizeof number);
    return number;
}

constexpr std::uint64_t number_size = sizeof(std::uint64_t);

// Up to `size` bytes from `start`; fewer where the file ends.
std::string read_at(int fd, std::uint64_t start, std::uint64_t size, const std::string& path) {
    std::string bytes(size, '\0');
    std::size_t done = 0;
    while (done < size) {
        const ssize_t n =
            ::pread(fd, bytes.data() + done, size - done, static_cast<off_t>(start + done));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail_by_system(errno, path);
        if (n == 0) break;
        done += static_cast<std::size_t>(n);
    }
    bytes.resize(done);
    return bytes;
}

void write_at(int fd, std::uint64_t start, std::string_view bytes, const std::string& path) {
    while (!bytes.empty()) {
        const ssize_t n = ::pwrite(fd, bytes.data(), bytes.size(), static_cast<off_t>(start));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail_by_system(errno, path);
        bytes.remove_prefix(static_cast<std::size_t>(n));
        start += static_cast<std::uint64_t>(n);
    }
}

}  // namespace

JournalFile::JournalFile(const std::string& path, std::string_view key) : path_(path) {
    refuse_other_file(path);
    fd_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (fd_ < 0) fail_by_system(errno, path_);
    try {
        if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) fail_by_system(errno, path_);
        const std::string due = std::string(magic) + bytes_of(key.size()) + std::string(key);
        header_checksum_ = checksum(first_checksum, due);
        const std::string header = due + bytes_of(header_checksum_);
        end_ = header.size();
        if (read_at(fd_, 0, end_, path_) == header) {
            find_entries();
        } else {
            truncate(0);
            write_at(fd_, 0, header, path_);
        }
    } catch (...) {
        ::close(fd_);
        throw;
    }
}

void JournalFile::refuse_other_file(const std::string& path) {
    check_replaceable(path);
    const std::string head = first_bytes(path, magic.size());
    const std::size_t n = head.size();
    std::size_t n_equal = 0;
    for (std::size_t i = 0; i < n; ++i) n_equal += head[i] == magic[i] || head[i] == 0;
    if (2 * n_equal < n)  // more than damage; zeros are what a power cut leaves
        io::fail(path, "", "is no journal of steps, for which its name is kept",
                 "move it away, or choose another output folder");
}

JournalFile::~JournalFile() {
    if (fd_ >= 0) ::close(fd_);
}

// An entry: size, content, checksum.
void JournalFile::find_entries() {
    const std::uint64_t size = std::filesystem::file_size(path_);
    std::uint64_t sum = header_checksum_;
    while (end_ + 2 * number_size <= size) {
        const std::string length = read_at(fd_, end_, number_size, path_);
        const std::uint64_t n = number_of(length), start = end_ + number_size;
        if (n > size - start - number_size) break;
        const std::string content = read_at(fd_, start, n + number_size, path_);
        const std::string_view bytes(content.data(), n);
        sum = checksum(checksum(sum, length), bytes);
        if (number_of(std::string_view(content).substr(n)) != sum) break;
        entries_.push_back({start, n, sum});
        end_ = start + n + number_size;
    }
    if (end_ < size) truncate(end_);
}

std::string JournalFile::read(std::size_t i) const {
    const Entry& entry = entries_.at(i);
    const std::uint64_t before = i == 0 ? header_checksum_ : entries_[i - 1].checksum;
    std::string content = read_at(fd_, entry.start, entry.size, path_);
    if (checksum(checksum(before, bytes_of(entry.size)), content) != entry.checksum)
        fail_by_system(EIO, path_);
    return content;
}

std::string JournalFile::read_front(std::size_t i, std::uint64_t n) const {
    const Entry& entry = entries_.at(i);
    return read_at(fd_, entry.start, std::min(n, entry.size), path_);
}

void JournalFile::cut(std::size_t n) {
    if (n >= entries_.size()) return;
    truncate(entries_[n].start - number_size);
    end_ = entries_[n].start - number_size;
    entries_.resize(n);
}

void JournalFile::append(std::string_view entry) {
    const std::uint64_t before = entries_.empty() ? header_checksum_ : entries_.back().checksum;
    const std::string length = bytes_of(entry.size());
    const std::uint64_t sum = checksum(checksum(before, length), entry);
    const std::uint64_t start = end_ + number_size;
    try {
        write_at(fd_, end_, length, path_);
        write_at(fd_, start, entry, path_);
        write_at(fd_, start + entry.size(), bytes_of(sum), path_);
    } catch (...) {
        // Where this fails too, the checksum tells the next reader.
        [[maybe_unused]] const int ignored = ::ftruncate(fd_, static_cast<off_t>(end_));
        throw;
    }
    entries_.push_back({start, entry.size(), sum});
    end_ = start + entry.size() + number_size;
}

void JournalFile::remove() {
    if (::unlink(path_.c_str()) != 0 && errno != ENOENT) fail_by_system(errno, path_);
    ::close(fd_);
    fd_ = -1;
}

void JournalFile::truncate(std::uint64_t size) {
    if (::ftruncate(fd_, static_cast<off_t>(size)) != 0) fail_by_system(errno, path_);
}

}  // namespace tricontact::io

#include "io/results/journal_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "files/digest.h"
#include "files/partial_file.h"
#include "io/keys/messages.h"
#include "io/results/atomic_file.h"

namespace tricontact::io {

namespace {

// Followed by the sizes of content and the content; numbers in the machine's own byte order: a
// journal stays where it was written.
constexpr std::string_view journal_head = "tricontact journal 2\n";

[[noreturn]] void fail_by_system(int error) {
    throw std::system_error(error, std::generic_category());
}

// Of everything before the content and of the content.
std::string checksum(const std::string& before, std::string_view content) {
    return (files::Digest() << before << content).text();
}

std::string bytes_of(std::uint64_t number) {
    return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::uint64_t number_of(std::string_view bytes) {
    std::uint64_t number = 0;
    std::memcpy(&number, bytes.data(), sizeof number);
    return number;
}

constexpr std::uint64_t number_size = sizeof(std::uint64_t), checksum_size = 32;

// Up to `size` bytes from `start`; fewer where the file ends.
std::string read_at(int fd, std::uint64_t start, std::uint64_t size) {
    std::string bytes(size, '\0');
    std::size_t done = 0;
    while (done < size) {
        const ssize_t n =
            ::pread(fd, bytes.data() + done, size - done, static_cast<off_t>(start + done));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) fail_by_system(errno);
        if (n == 0) break;
        done += static_cast<std::size_t>(n);
    }
    bytes.resize(done);
    return bytes;
}

}  // namespace

JournalFile::JournalFile(const std::string& path, std::string_view key) : path_(path) {
    refuse_other_file(path);
    fd_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (fd_ < 0) fail_by_system(errno);
    try {
        if (::flock(fd_, LOCK_EX | LOCK_NB) != 0) fail_by_system(errno);
        const std::string due = std::string(journal_head) + bytes_of(key.size()) + std::string(key);
        header_checksum_ = checksum({}, due);
        const std::string header = due + header_checksum_;
        end_ = header.size();
        if (read_at(fd_, 0, end_) == header) {
            find_entries();
        } else {
            truncate(0);
            files::write_all(fd_, header);
        }
    } catch (...) {
        ::close(fd_);
        throw;
    }
}

void JournalFile::refuse_other_file(const std::string& path) {
    check_replaceable(path);
    const std::string head = first_bytes(path, journal_head.size());
    const std::size_t n = head.size();
    std::size_t n_equal = 0;
    for (std::size_t i = 0; i < n; ++i) n_equal += head[i] == journal_head[i] || head[i] == 0;
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
    while (end_ + number_size + checksum_size <= size) {
        const std::uint64_t n = number_of(read_at(fd_, end_, number_size));
        const std::uint64_t start = end_ + number_size;
        if (n > size - start - checksum_size) break;
        const std::string content = read_at(fd_, start, n + checksum_size);
        const std::string_view bytes(content);
        const std::string sum = checksum(checksum_before(entries_.size()), bytes.substr(0, n));
        if (bytes.substr(n) != sum) break;
        entries_.push_back({start, n, sum});
        end_ = start + n + checksum_size;
    }
    if (end_ < size) truncate(end_);
}

const std::string& JournalFile::checksum_before(std::size_t i) const {
    return i == 0 ? header_checksum_ : entries_[i - 1].checksum;
}

std::string JournalFile::read(std::size_t i) const {
    const Entry& entry = entries_.at(i);
    std::string content = read_at(fd_, entry.start, entry.size);
    if (checksum(checksum_before(i), content) != entry.checksum) fail_by_system(EIO);
    return content;
}

std::string JournalFile::read_front(std::size_t i, std::uint64_t n) const {
    const Entry& entry = entries_.at(i);
    return read_at(fd_, entry.start, std::min(n, entry.size));
}

void JournalFile::cut(std::size_t n) {
    if (n >= entries_.size()) return;
    truncate(entries_[n].start - number_size);
    end_ = entries_[n].start - number_size;
    entries_.resize(n);
}

void JournalFile::append(std::string_view entry) {
    const std::string sum = checksum(checksum_before(entries_.size()), entry);
    try {
        if (::lseek(fd_, static_cast<off_t>(end_), SEEK_SET) < 0) fail_by_system(errno);
        files::write_all(fd_, bytes_of(entry.size()));
        files::write_all(fd_, entry);
        files::write_all(fd_, sum);
    } catch (...) {
        // Where this fails too, the checksum tells the next reader.
        [[maybe_unused]] const int ignored = ::ftruncate(fd_, static_cast<off_t>(end_));
        throw;
    }
    entries_.push_back({end_ + number_size, entry.size(), sum});
    end_ += number_size + entry.size() + checksum_size;
}

void JournalFile::remove() {
    if (::unlink(path_.c_str()) != 0 && errno != ENOENT) fail_by_system(errno);
    ::close(fd_);
    fd_ = -1;
}

void JournalFile::truncate(std::uint64_t size) {
    if (::ftruncate(fd_, static_cast<off_t>(size)) != 0) fail_by_system(errno);
}

}  // namespace tricontact::io

#include "io/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "io/messages.h"

namespace tricontact::io {

namespace {

constexpr std::size_t megabyte = 1'000'000;

class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return fd_; }

  private:
    int fd_;
};

std::string with_article(const std::string& kind) {
    constexpr std::string_view vowels = "aeiou";
    return (vowels.find(kind.front()) == vowels.npos ? "a " : "an ") + kind;
}

[[noreturn]] void refuse(const std::string& path, int error, const std::string& kind) {
    const std::string remedy = error == ENOENT && kind == "case file"
                                   ? "check the path; `tricontact list` names the cases"
                               : error == ENOENT ? "check the path"
                               : error == EACCES ? "give yourself the permission to read it"
                                                 : "name a readable " + kind;
    fail(path, "", "the file cannot be read (" + std::generic_category().message(error) + ")",
         remedy);
}

[[noreturn]] void refuse_size(const std::string& path, const std::string& kind,
                              std::size_t most_mb) {
    fail(path, "", "is larger than " + std::to_string(most_mb) + " MB: no " + kind,
         "name " + with_article(kind));
}

void check_kind(const std::string& path, const struct stat& status, const std::string& kind) {
    if (S_ISDIR(status.st_mode))
        fail(path, "", "is a directory", "name " + with_article(kind) + " inside it");
    if (!S_ISREG(status.st_mode))
        fail(path, "", "is not a regular file", "name " + with_article(kind));
}

}  // namespace

std::string read_input_file(const std::string& path, std::string_view what, std::size_t most_mb) {
    const std::string kind(what);
    const std::size_t largest = most_mb * megabyte;
    // O_NONBLOCK: opening a named pipe must not wait for its writer.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (file.get() < 0 || ::fstat(file.get(), &status) != 0) refuse(path, errno, kind);
    check_kind(path, status, kind);
    if (static_cast<std::size_t>(status.st_size) > largest) refuse_size(path, kind, most_mb);
    std::string text;
    std::array<char, 65536> buffer{};
    while (text.size() <= largest) {
        const ssize_t n = ::read(file.get(), buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) refuse(path, errno, kind);
        if (n == 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(n));
    }
    refuse_size(path, kind, most_mb);
}

}  // namespace tricontact::io

#include "report/run_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <deque>
#include <string_view>
#include <vector>

namespace tricontact::report {

namespace {

[[noreturn]] void fail(const std::string& what, int error, bool is_missing = false) {
    throw ProgramError(fmt::format("{}: {}", what, std::strerror(error)), is_missing);
}

/// A file in memory. Unlike a pipe it never fills up, so neither side can wait for the other, and
/// a program that dies early cannot stop us with SIGPIPE.
class MemoryFile {
  public:
    /// Programs that are started have it under the same number if `inherited`.
    explicit MemoryFile(const char* name, bool inherited = false)
        : descriptor_(memfd_create(name, inherited ? 0 : MFD_CLOEXEC)) {
        if (descriptor_ < 0) fail("no memory for another program's data", errno);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { close(descriptor_); }

    int descriptor() const { return descriptor_; }

    void write_all(std::string_view text) const {
        while (!text.empty()) {
            const ssize_t written = write(descriptor_, text.data(), text.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) fail("cannot hand data to another program", errno);
            text.remove_prefix(static_cast<std::size_t>(written));
        }
    }

    std::string content() const {
        const off_t size = lseek(descriptor_, 0, SEEK_END);
        if (size < 0) fail("cannot read what another program wrote", errno);
        std::string text(static_cast<std::size_t>(size), '\0');
        for (std::size_t done = 0; done < text.size();) {
            const ssize_t got = pread(descriptor_, text.data() + done, text.size() - done,
                                      static_cast<off_t>(done));
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) fail("cannot read what another program wrote", errno);
            done += static_cast<std::size_t>(got);
        }
        return text;
    }

  private:
    int descriptor_;
};

/// The present environment without what changes gnuplot's numbers, start-up or terminal. Freed
/// memory is kept for the next picture, as long as it is glibc's; others know nothing of this.
std::vector<std::string> plain_environment() {
    std::vector<std::string> result{"LC_ALL=C", "MALLOC_MMAP_THRESHOLD_=33554432",
                                    "MALLOC_TRIM_THRESHOLD_=134217728"};
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text = *entry;
        if (!text.starts_with("LC_") && !text.starts_with("LANG") && !text.starts_with("GNU") &&
            !text.starts_with("MALLOC_"))
            result.emplace_back(text);
    }
    return result;
}

/// Starts the program on the given files and waits for its end; returns the wait status.
int run_on(std::vector<std::string> words, const MemoryFile& in, const MemoryFile& out,
           const MemoryFile& err) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::vector<std::string> environment = plain_environment();
    std::vector<char*> variables;
    variables.reserve(environment.size() + 1);
    for (std::string& entry : environment) variables.push_back(entry.data());
    variables.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
    pid_t child = 0;
    const int error = posix_spawnp(&child, words[0].c_str(), &actions, nullptr, arguments.data(),
                                   variables.data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) fail(fmt::format("cannot start '{}'", words[0]), error, true);

    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) fail("lost sight of another program", errno);
    return status;
}

}  // namespace

std::string run_program(const std::vector<std::string>& words, std::string_view input) {
    const MemoryFile in("input"), out("output"), err("message");
    in.write_all(input);
    if (lseek(in.descriptor(), 0, SEEK_SET) < 0) fail("cannot rewind an input", errno);
    const int status = run_on(words, in, out, err);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw ProgramError(words[0] + " failed: " + err.content(), false);
    return out.content();
}

std::vector<std::string> run_program(
    const std::vector<std::string>& words, std::size_t n,
    const std::function<std::string(const std::vector<std::string>& paths)>& input_for) {
    std::deque<MemoryFile> files;
    std::vector<std::string> paths, contents;
    for (std::size_t k = 0; k < n; ++k)
        paths.push_back(
            fmt::format("/proc/self/fd/{}", files.emplace_back("file", true).descriptor()));
    run_program(words, input_for(paths));
    for (const MemoryFile& file : files) contents.push_back(file.content());
    return contents;
}

}  // namespace tricontact::report

#include "papers/temporary_folder.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "io/results/atomic_file.h"

namespace tricontact::papers {

namespace {

// Waits for the end of its input, which comes with the end of the process that writes there, and
// survives what is sent to the terminal's processes.
constexpr const char* remover_script = R"(trap '' HUP INT QUIT TERM; read -r _; rm -rf -- "$1")";

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "tricontact-XXXXXX").string();
    if (!::mkdtemp(name.data())) io::refuse_output(name, "cannot be made", errno);
    path_ = name;
    start_remover();
}

// Where no further process can be had, the folder stays if this one is killed.
void TemporaryFolder::start_remover() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        ::posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID);
    std::array<std::string, 5> words{"sh", "-c", remover_script, "sh", path_};
    std::array<char*, 6> arguments{};
    for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
    std::array<char*, 2> environment{const_cast<char*>("PATH=/usr/bin:/bin"), nullptr};
    if (::posix_spawn(&remover_, "/bin/sh", &actions, &attributes, arguments.data(),
                      environment.data()) != 0)
        remover_ = -1;
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[0]);
    alive_ = ends[1];
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    if (alive_ >= 0) ::close(alive_);
    while (remover_ > 0 && ::waitpid(remover_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

}  // namespace tricontact::papers

#include "studies/worker_pool.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <list>
#include <system_error>
#include <utility>

#include "contact/base/interruption.h"
#include "files/partial_file.h"

namespace tricontact::studies {

namespace {

using Task = std::function<std::string(std::size_t)>;
using Done = std::function<void(std::size_t, const WorkerReport&)>;

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

// What has come whole ends with this; a process may die in between.
constexpr char end_mark = '\n';

// `_exit`: nothing of the parent's may be flushed, closed or removed twice.
[[noreturn]] void work(std::size_t i, const Task& task, int fd, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::signal(SIGINT, SIG_DFL);  // the handler of a host such as Python would let it live on
    if (::getppid() != parent) ::_exit(1);  // it ended before the line above
    const contact::Interruption none({});
    try {
        files::write_all(fd, task(i) + end_mark);
    } catch (const std::system_error&) {  // nobody reads it any more
        ::_exit(1);
    }
    ::_exit(0);
}

// A child process and the pipe from it. Its end is the child's end.
class Worker {
  public:
    Worker(std::size_t i, const Task& task) : task_(i) {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0) fail("no pipe for a further process");
        const pid_t parent = ::getpid();
        pid_ = ::fork();
        if (pid_ == 0) {
            ::close(ends[0]);
            work(i, task, ends[1], parent);
        }
        ::close(ends[1]);
        fd_ = ends[0];
        if (pid_ < 0) {
            ::close(fd_);
            fail("no further process");
        }
    }
    ~Worker() {
        if (fd_ < 0) return;
        ::kill(pid_, SIGKILL);
        wait();
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    std::size_t task() const { return task_; }
    int fd() const { return fd_; }

    // False when the child has closed its end.
    bool read() {
        std::array<char, 65536> buffer{};
        const ssize_t n = ::read(fd_, buffer.data(), buffer.size());
        if (n < 0) return errno == EINTR;
        text_.append(buffer.data(), static_cast<std::size_t>(n));
        return n > 0;
    }
    WorkerReport report() {
        const int status = wait();
        const bool whole = !text_.empty() && text_.back() == end_mark;
        if (whole) text_.pop_back();
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && whole) return {.text = text_};
        if (!WIFSIGNALED(status)) return {.failure = "its process ended without a result"};
        const int signal = WTERMSIG(status);
        return {.failure = "its process was ended by signal " + std::to_string(signal) + " (" +
                           ::strsignal(signal) + ")",
                .killed =
                    signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP};
    }

  private:
    int wait() {
        int status = 0;
        while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        ::close(std::exchange(fd_, -1));
        return status;
    }

    std::size_t task_;
    pid_t pid_ = -1;
    int fd_ = -1;
    std::string text_;
};

void run_once(const std::vector<std::size_t>& tasks, int n_workers, const Task& task,
              const Done& done, const std::function<void()>& attend) {
    const int patience = attend ? 100 : -1;  // between two calls of `attend` [ms]; -1: no end
    std::list<Worker> workers;
    std::size_t next = 0;
    while (next < tasks.size() || !workers.empty()) {
        while (next < tasks.size() && workers.size() < static_cast<std::size_t>(n_workers))
            workers.emplace_back(tasks[next++], task);
        // Until one of them has something to say, a signal comes, or the patience ends.
        std::vector<pollfd> ends;
        for (const Worker& worker : workers) ends.push_back({worker.fd(), POLLIN, 0});
        if (::poll(ends.data(), ends.size(), patience) < 0 && errno != EINTR)
            fail("waiting for processes");
        if (attend) attend();
        auto worker = workers.begin();
        for (const pollfd& end : ends) {
            const auto one = worker++;
            if (end.revents == 0 || one->read()) continue;
            const std::size_t i = one->task();
            const WorkerReport report = one->report();
            workers.erase(one);
            done(i, report);
        }
    }
}

}  // namespace

void run_in_processes(const std::vector<std::size_t>& tasks, int n_workers, const Task& task,
                      const Done& done, const std::function<void()>& attend) {
    std::vector<std::size_t> killed;
    const Done done_or_killed = [&](std::size_t i, const WorkerReport& report) {
        if (report.killed)
            killed.push_back(i);
        else
            done(i, report);
    };
    run_once(tasks, n_workers, task, done_or_killed, attend);
    run_once(killed, 1, task, done, attend);
}

}  // namespace tricontact::studies

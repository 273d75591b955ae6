#include "studies/worker_pool.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <list>
#include <optional>
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

// Of a message from a child: the length of the text that follows, and whether the child takes
// another task.
struct Head {
    std::size_t length = 0;
    bool goes_on = false;
};

constexpr std::size_t no_further = static_cast<std::size_t>(-1);

// A process that took longer does not go on: what is left over of large tasks stays in none, and
// its start costs nothing beside them.
constexpr std::chrono::seconds short_life{1};

bool read_all(int fd, void* to, std::size_t n) {
    for (auto* at = static_cast<char*>(to); n > 0;) {
        const ssize_t got = ::read(fd, at, n);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        n -= static_cast<std::size_t>(got);
    }
    return true;
}

// Tasks one after the other, so that short ones share what the first had to prepare.
// `_exit`: nothing of the parent's may be flushed, closed or removed twice.
[[noreturn]] void work(const Task& task, int fd, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::signal(SIGINT, SIG_DFL);  // the handler of a host such as Python would let it live on
    if (::getppid() != parent) ::_exit(1);  // it ended before the line above
    const contact::Interruption none({});
    const auto start = std::chrono::steady_clock::now();
    try {
        std::size_t i = no_further;
        for (bool goes_on = true; goes_on && read_all(fd, &i, sizeof i) && i != no_further;) {
            const std::string text = task(i);
            goes_on = std::chrono::steady_clock::now() - start < short_life;
            const Head head{text.size(), goes_on};
            files::write_all(fd,
                             std::string(reinterpret_cast<const char*>(&head), sizeof head) + text);
        }
    } catch (const std::system_error&) {  // nobody reads it any more
        ::_exit(1);
    }
    ::_exit(0);
}

// A child process and the socket to it. When the child's end closes, it has ended.
class Worker {
  public:
    explicit Worker(const Task& task) {
        std::array<int, 2> ends{};
        if (::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0)
            fail("no socket for a further process");
        const pid_t parent = ::getpid();
        pid_ = ::fork();
        if (pid_ == 0) {
            ::close(ends[0]);
            work(task, ends[1], parent);
        }
        ::close(ends[1]);
        fd_ = ends[0];
        if (pid_ < 0) {
            ::close(fd_);
            fail("no further process");
        }
    }
    ~Worker() {
        ::close(fd_);
        if (pid_ < 0) return;
        ::kill(pid_, SIGKILL);
        wait();
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    int fd() const { return fd_; }
    std::optional<std::size_t> task() const { return task_; }

    /// The next task; without one it ends.
    void give(std::optional<std::size_t> task) {
        task_ = task;
        given_ = Clock::now();
        const std::size_t i = task.value_or(no_further);
        ::send(fd_, &i, sizeof i, MSG_NOSIGNAL);  // one that has ended is seen by its end
    }

    // False when the child has closed its end.
    bool read() {
        std::array<char, 65536> buffer{};
        const ssize_t n = ::read(fd_, buffer.data(), buffer.size());
        if (n < 0) return errno == EINTR;
        text_.append(buffer.data(), static_cast<std::size_t>(n));
        return n > 0;
    }
    // What the task returned, once it is there.
    std::optional<WorkerReport> finished() {
        Head head;
        if (text_.size() < sizeof head) return std::nullopt;
        std::memcpy(&head, text_.data(), sizeof head);
        if (text_.size() < sizeof head + head.length) return std::nullopt;
        goes_on_ = head.goes_on;
        task_.reset();
        return WorkerReport{.text = std::exchange(text_, {}).substr(sizeof head)};
    }
    bool goes_on() const { return goes_on_; }
    auto time_at_task() const { return Clock::now() - given_; }
    // After its end: why the task it had came to nothing.
    WorkerReport failure() {
        const int status = wait();
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
        pid_ = -1;
        return status;
    }

    using Clock = std::chrono::steady_clock;

    pid_t pid_ = -1;
    int fd_ = -1;
    std::optional<std::size_t> task_;
    Clock::time_point given_;
    bool goes_on_ = true;
    std::string text_;
};

// What a worker has said: true if its process has ended.
bool hear(Worker& worker, const Done& done,
          const std::function<std::optional<std::size_t>()>& next) {
    if (!worker.read()) {
        if (const auto i = worker.task()) done(*i, worker.failure());
        return true;
    }
    const auto task = worker.task();
    if (!task) return false;
    if (auto told = worker.finished()) {
        told->was_short = worker.time_at_task() < short_task;
        if (!told->was_short) done(*task, *told);
        if (worker.goes_on()) worker.give(next());
        if (told->was_short) done(*task, *told);
    }
    return false;
}

void run_once(const std::vector<std::size_t>& tasks, int n_workers, const Task& task,
              const Done& done, const std::function<void()>& attend) {
    const int patience = attend ? 100 : -1;  // between two calls of `attend` [ms]; -1: no end
    std::list<Worker> workers;
    auto at = tasks.begin();
    const auto next = [&] { return at == tasks.end() ? std::nullopt : std::optional(*at++); };
    while (at != tasks.end() || !workers.empty()) {
        while (at != tasks.end() && workers.size() < static_cast<std::size_t>(n_workers))
            workers.emplace_back(task).give(next());
        // Until one of them has something to say, a signal comes, or the patience ends.
        std::vector<pollfd> ends;
        for (const Worker& worker : workers) ends.push_back({worker.fd(), POLLIN, 0});
        if (::poll(ends.data(), ends.size(), patience) < 0 && errno != EINTR)
            fail("waiting for processes");
        if (attend) attend();
        auto worker = workers.begin();
        for (const pollfd& end : ends) {
            const auto one = worker++;
            if (end.revents != 0 && hear(*one, done, next)) workers.erase(one);
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

#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tricontact::studies {

/// What a task in a process of its own came to.
struct WorkerReport {
    std::string text = {};     ///< what the task returned
    std::string failure = {};  ///< how its process ended, if not by returning
    bool killed = false;       ///< by a signal that others send, or the system for want of memory
    bool was_short = false;    ///< the process has got another task already
};

/// A task that takes no longer is short: the next one follows before its result is kept, and
/// results of several are kept together. What takes longer is kept before anything follows it.
inline constexpr std::chrono::milliseconds short_task{5};

/// Runs tasks in other processes, short ones several after each other in one, so that one that
/// crashes takes no other with it; at most `n_workers` (at least 1) at a time, in the order given.
/// One that was killed runs once more alone after the others: for want of memory it may do better,
/// and killed by hand it is no failure. `task` runs in the child and must not throw; `done` in this
/// process, once for each, as they end. When this process ends, however, its children do. Other
/// threads of this process must not hold what a task needs. `attend`, if there is one, is called
/// again and again while they work. Throws std::system_error if no process can be started; whatever
/// `done` or `attend` throws ends the children.
void run_in_processes(const std::vector<std::size_t>& tasks, int n_workers,
                      const std::function<std::string(std::size_t)>& task,
                      const std::function<void(std::size_t, const WorkerReport&)>& done,
                      const std::function<void()>& attend = {});

}  // namespace tricontact::studies

#pragma once

#include <functional>
#include <utility>

namespace tricontact::contact {

/// What the running thread calls between the steps of a long computation; may throw to end it.
/// Empty unless an Interruption lives. Further threads and processes have none.
inline thread_local std::function<void()> interruption_check;

/// Lets whoever called a long computation end it, as long as this object lives. An empty check
/// keeps others away, e.g. in the process of a worker.
class Interruption {
  public:
    explicit Interruption(std::function<void()> check)
        : before_(std::exchange(interruption_check, std::move(check))) {}
    ~Interruption() { interruption_check = std::move(before_); }
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

  private:
    std::function<void()> before_;
};

/// A place where a computation may be ended.
inline void interruption_point() {
    if (interruption_check) interruption_check();
}

}  // namespace tricontact::contact

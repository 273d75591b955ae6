#pragma once

#include <sys/types.h>

#include <string>

namespace tricontact::papers {

/// A folder that goes away with this object, and also if the process is killed, by whatever
/// signal: a process of its own waits for that.
class TemporaryFolder {
  public:
    /// Throws contact::InputError if there is no place for it.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::string& path() const { return path_; }

  private:
    void start_remover();

    std::string path_;
    int alive_ = -1;  // open as long as this process lives: its end is what the other waits for
    pid_t remover_ = -1;
};

}  // namespace tricontact::papers

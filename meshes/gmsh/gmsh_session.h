#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace tricontact::meshes {

/// gmsh's library, switched on for the lifetime of this object: silent, one thread, no user's
/// configuration, an empty model. There is one library per process: a second session waits for the
/// first. The process's locale, which gmsh changes, is restored, and nothing stays on the disk.
/// Not to be nested. Throws std::runtime_error if gmsh cannot start.
class GmshSession {
  public:
    GmshSession();
    ~GmshSession();

    /// Calls gmsh; what it throws becomes a std::runtime_error with gmsh's own message.
    static void call(const std::function<void()>& function);

  private:
    std::unique_lock<std::mutex> lock_;
    std::string locale_;
};

}  // namespace tricontact::meshes

#pragma once

#include <string>

namespace tricontact::files {

/// Keeps others that ask for it out of a folder, of this process or another one, as long as it is
/// held; the end of the process ends it.
class FolderLock {
  public:
    FolderLock() = default;
    ~FolderLock() { release(); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// False if somebody else holds it, or the folder is gone. Where the file system has no locks
    /// nobody is kept out.
    bool take(const std::string& folder);
    void release();

  private:
    int descriptor_ = -1;
};

}  // namespace tricontact::files

#include "files/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace tricontact::files {

bool FolderLock::take(const std::string& folder) {
    release();
    descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0) return errno != ENOENT;  // one that may not be read is not locked
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
        const bool is_held = errno == EWOULDBLOCK;
        release();
        return !is_held;
    }
    // Whoever held it may have removed the folder when it gave up.
    struct stat held {
    }, there{};
    if (::fstat(descriptor_, &held) == 0 && ::stat(folder.c_str(), &there) == 0 &&
        held.st_ino == there.st_ino && held.st_dev == there.st_dev)
        return true;
    release();
    return false;
}

void FolderLock::release() {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

}  // namespace tricontact::files

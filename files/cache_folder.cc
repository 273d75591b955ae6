#include "files/cache_folder.h"

#include <cstdlib>

namespace tricontact::files {

std::string cache_folder() {
    const char* own = std::getenv("TRICONTACT_CACHE");
    if (own && *own == '/') return own;
    // The XDG specification: relative paths are invalid and to be ignored.
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache && *cache == '/') return std::string(cache) + "/tricontact";
    const char* home = std::getenv("HOME");
    if (home && *home) return std::string(home) + "/.cache/tricontact";
    return "";
}

}  // namespace tricontact::files

#pragma once

#include <string>

namespace tricontact::files {

/// Where the program keeps what it can compute again: $TRICONTACT_CACHE if that is an absolute
/// path, $XDG_CACHE_HOME/tricontact or ~/.cache/tricontact; empty where there is none of them. The
/// folder may not exist yet.
std::string cache_folder();

}  // namespace tricontact::files

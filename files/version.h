#pragma once

namespace tricontact::files {

/// The program's version, "0.2.0": in every file that it writes.
extern const char* const version;

}  // namespace tricontact::files

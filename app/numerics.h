#pragma once

#include <string_view>

namespace tricontact::app {

/// Digest of all sources on which numbers depend that are kept for later calls (app/CMakeLists.txt
/// names them): belongs to the key of everything that is found again, since the program's version
/// does not tell apart two states of the code between two versions.
std::string_view numerics_digest();

}  // namespace tricontact::app

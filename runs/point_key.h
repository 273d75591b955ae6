#pragma once

#include <string>
#include <string_view>

#include "contact/case.h"

namespace tricontact::runs {

/// Digest of all sources on which numbers depend that are kept for later calls (app/CMakeLists.txt
/// names them): belongs to the key of everything that is found again, since the program's version
/// does not tell apart two states of the code between two versions.
std::string_view numerics_digest();

/// Version and numerics_digest() of the program.
std::string program_identity();

/// Digest of the program's identity and the resolved text of a case: what results depend on, but
/// for the files that the text names.
std::string point_key(const std::string& resolved);

/// Digests of what the files hold that the case names, a line each; empty if it names none. Belongs
/// beside the resolved text wherever results are found again by it. Throws contact::InputError if
/// one cannot be read.
std::string file_digests(const contact::Case& c);

}  // namespace tricontact::runs

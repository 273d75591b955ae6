#include "files/version.h"

namespace tricontact::files {

const char* const version = TRICONTACT_VERSION;

}  // namespace tricontact::files

#include "tests/paths.h"

namespace tricontact::paths {

std::string source(const std::string& name) {
    return TRICONTACT_SOURCE_DIR "/" + name;
}
std::string program() {
    return TRICONTACT_PROGRAM;
}
std::string layer_cache() {
    return TRICONTACT_LAYER_CACHE;
}

}  // namespace tricontact::paths

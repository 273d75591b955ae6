#include "benchmarks/reference/reference.h"

#include <algorithm>

namespace tricontact::benchmarks {

bool Reference::is_prescribed(const std::string& key) const {
    return std::ranges::find(prescribed, key) != prescribed.end();
}

}  // namespace tricontact::benchmarks

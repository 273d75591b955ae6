#pragma once

#include <string_view>

namespace tricontact::fem {

/// Digest of the sources that condense a layer: a kept layer is that of the code that made it.
std::string_view condensing_sources_digest();

}  // namespace tricontact::fem

#pragma once

#include <string>
#include <string_view>

namespace tricontact::report {

/// The bytes as zlib's stream (RFC 1950) in base64, for a page that unpacks them by
/// DecompressionStream("deflate").
std::string packed(std::string_view bytes);

}  // namespace tricontact::report

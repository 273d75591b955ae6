#pragma once

#include <string>
#include <string_view>

namespace tricontact::report {

/// RFC 4648, section 4, with padding: how a data URI carries an image.
std::string base64(std::string_view bytes);

}  // namespace tricontact::report

#pragma once

#include <string_view>

namespace tricontact::bem {

/// How a file of influence coefficients begins (docs/influence-format.md).
inline constexpr std::string_view influence_file_title =
    "tricontact influence coefficients, version ";

}  // namespace tricontact::bem

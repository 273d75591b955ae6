#pragma once

#include <limits>

namespace tricontact::contact {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// A number that is not known, or does not exist.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

}  // namespace tricontact::contact

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contact/bodies/profile_curve.h"

namespace tricontact::io {

/// The profile of a body of revolution from a CSV table: columns r and h with their units, from
/// (0, 0) on, radii increasing and heights not falling, and perhaps a column `kink` of 0 and 1, 1
/// where the slope jumps. Throws contact::InputError.
std::vector<contact::ProfileCurve::Point> read_profile_table(const std::string& path);
std::vector<contact::ProfileCurve::Point> parse_profile_table(std::string_view text,
                                                              const std::string& name);

}  // namespace tricontact::io

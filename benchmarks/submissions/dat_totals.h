#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// Key of a total: the normal force of a second set that balances the first one, whose sum shows
/// whether the code's solution is in equilibrium.
inline constexpr const char* balancing_force = "balancing_force";

/// Whether a text is what CalculiX prints (.dat), by its headings.
bool is_calculix_print(std::string_view text);

/// What a .dat file of CalculiX states of its last time: `total force` of sets, the statistics of
/// contact pairs, energies of sets. `axes`: the letters of the axes of the file, z normal to the
/// surface ("xzy" where y is normal); empty: the largest force is along the normal. Not the
/// pressures at integration points, which have no positions. Notes name what is not used. Throws
/// contact::InputError.
std::map<std::string, Total> parse_dat(std::string_view text, const std::string& name,
                                       const std::string& axes, std::vector<std::string>& notes);

}  // namespace tricontact::benchmarks

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tricontact::io {

/// The approach of a force curve, and the retraction behind it where that was asked for.
struct ForceCurve {
    std::vector<double> depth;  ///< of the tip [m], growing into the sample, counted from anywhere
    std::vector<double> force;  ///< [N]
    std::string reading;        ///< which segment and columns were taken, for people
};

/// Whether a text is a force curve as the programs of JPK (Bruker) export it: one or more segments
/// of rows, above each of them lines of # that name its columns and units.
bool is_force_curve(std::string_view text);

/// Reads the segment "extend" of such a text, and "retract" if there is one and it is wanted. The
/// depth is that of the tip: of verticalTipPosition,
/// else of the height with the deflection F/k of the cantilever taken off, k the file's
/// springConstant. Throws contact::InputError, naming line, value, rule and remedy, also where the
/// deflection is no force and where a height without k holds the bending. `name`: for messages.
ForceCurve force_curve(std::string_view text, const std::string& name, std::size_t most_rows,
                       bool with_retraction = false);

}  // namespace tricontact::io

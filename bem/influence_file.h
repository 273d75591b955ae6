#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bem/influence.h"

namespace tricontact::bem {

/// Influence coefficients of square cells [m/Pa] at the relative positions (i h, j h) >= 0 of
/// displaced point and loaded cell; of bodies with the symmetry planes x and y the rest follows.
struct InfluenceTable {
    double spacing = 0;                        ///< h [m]
    int n_x = 0, n_y = 0;                      ///< positions along x and y, from 0 on
    std::vector<InfluenceCoefficients> cells;  ///< i fastest

    const InfluenceCoefficients& at(int i, int j) const {
        return cells[static_cast<std::size_t>(j) * n_x + i];
    }
};

/// Pressure displaces the surface aside by so much of what tractions do at the same place that it
/// matters; that of a half-space does from |Dundurs' beta| of about 0.002 on.
bool couples(const InfluenceTable& table);

/// As docs/reference/influence-format.md describes it; numbers read back to the same bits.
std::string influence_text(const InfluenceTable& table);

/// Reads such a text. Throws contact::InputError with file and line if it is none, of another
/// version, cut short, holds what is no finite number, or lacks the symmetry of reciprocal bodies:
/// K_xz = -K_zx, K_yz = -K_zy, K_xy = K_yx, zero where the mirror image has the other sign.
InfluenceTable read_influence(const std::string& path);

/// Throws contact::InputError, naming the file, unless the table is of cells of this size [m].
void check_spacing(const InfluenceTable& table, const std::string& path, double spacing);

/// How a file of influence coefficients begins (docs/reference/influence-format.md).
inline constexpr std::string_view influence_file_title =
    "tricontact influence coefficients, version ";

}  // namespace tricontact::bem

#pragma once

#include <string>
#include <vector>

#include "benchmarks/reference/reference.h"
#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// Share of the largest load from which on a point counts as touched.
inline constexpr double touched_share = .02;

/// Where the points of a code's surface lie, in the unit of its file.
struct SurfaceLayout {
    Geometry geometry = Geometry::spatial;  ///< of the points: over r, along x, over x and y
    std::vector<double> x, y;               ///< r instead of x on a profile; y only if spatial
    std::vector<double> height;             ///< of the points, where the file has it; else empty
    Meaning x_axis = Meaning::x, y_axis = Meaning::y;  ///< columns that became x and y
    std::optional<std::string> unit;                   ///< of positions
    std::string text;                                  ///< "profile over r", "surface over x and z"
};

/// Finds which coordinates span the surface: those along which the points with contact spread; one
/// that stays within a fifth of them is the height. Throws contact::InputError where there are no
/// positions, or a profile in a problem whose fields vary over a surface.
SurfaceLayout surface_layout(const MeshField& field, Geometry problem);

/// The column that says the normal load: pressure, nodal forces along the normal, or the component
/// of a vector or of the stress along the height. Throws contact::InputError if there is none.
const FieldColumn& normal_column(const MeshField& field, const SurfaceLayout& layout);

/// Columns of tangential traction or force along the layout's x and y; null where there are none.
struct TangentialColumns {
    const FieldColumn *x = nullptr, *y = nullptr;
};
TangentialColumns tangential_columns(const MeshField& field, const SurfaceLayout& layout);

/// Whether a column's values are forces [N] by its meaning or unit, stresses or tractions; empty
/// where neither says.
std::optional<bool> says_force(const FieldColumn& column);

}  // namespace tricontact::benchmarks

#pragma once

#include <optional>

namespace tricontact::contact {

struct Case;

/// How a surface is divided: the cells of boundary elements, on which the nodes of a rough body lie
/// and by which others count. Kept with a case, see Case::of().
struct Cells {
    std::optional<double> spacing;     ///< side h along x [m]
    std::optional<double> per_radius;  ///< Hertz radius / h, instead
    std::optional<double> ratio;       ///< side along y over that along x
    /// Where the centre of a cell lies from the body's lowest point at the origin, over the cell's
    /// sides, -1/2 to 1/2.
    std::optional<double> shift_x, shift_y;

    /// h [m]; `radius`: of the contact on the half-space [m].
    double side(double radius) const { return spacing ? *spacing : radius / *per_radius; }
};

/// h of the case's cells [m].
double cell_side(const Case& c);

}  // namespace tricontact::contact

#pragma once

#include <optional>
#include <vector>

namespace tricontact::fem {

/// What bodies displace under a uniform traction on one square cell of their surface, or strip of a
/// section, by the relative position (i h, j h) >= 0 of displaced and loaded cell: of bodies that
/// are the same anywhere along their surface. Relative displacements, substrate minus indenter,
/// are means over a strip, or those of the middle of a cell [m/Pa]; x and y along the surface, z
/// into the substrate; `xz` is u_x per pressure.
struct CellResponse {
    struct Coefficients {
        double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;
    };
    double size = 0;                  ///< h [m]
    int n_x = 0, n_y = 0;             ///< positions along x and y, from 0 on
    std::vector<Coefficients> cells;  ///< i fastest
    double contact_radius = 0;        ///< of the contact, found on coarse elements [m]
    /// Largest difference between any two cells of the contact, over the response of a cell to
    /// itself [-]: bodies end somewhere, and are not quite the same along the surface. Empty where
    /// it is not known.
    std::optional<double> variation;
};

}  // namespace tricontact::fem

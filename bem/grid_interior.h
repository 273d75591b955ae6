#pragma once

#include <span>
#include <vector>

#include "bem/interior_influence.h"
#include "contact/compliances/compliance.h"
#include "contact/compliances/interior.h"

namespace tricontact::bem {

/// Where fields inside are looked at.
struct InteriorView {
    InteriorBody body;
    std::vector<double> depths;  ///< [m], increasing from 0
    int n_threads = 1;           ///< results do not depend on it
};

/// Depths [m] from 0 to `depth`: equal steps of a spacing or a/25, whichever is larger, down to a,
/// growing by a fifth each below. `contact_radius`: a [m].
std::vector<double> interior_depths(double spacing, double contact_radius, double depth);

/// Displacements and stresses below the cells' centres of `grid` and half of its shorter side
/// around it, under tractions that are constant on cells, as a contact::Interior on a rectilinear
/// grid: exact for such tractions but for the layers' kernel. `applied` is their force and
/// `strain_energy` half their work. Zero-padded FFT convolution per depth: two transforms
/// per field (18, or 9 without tangential tractions) and nine back.
///
/// A side of more than 256 cells is taken by blocks of 3, 5, ... cells with their mean tractions;
/// points are thinned to 128 along a side, and more and more outside the grid. Both bound time and
/// memory.
///
/// In plane strain the grid is one row of strips and the points are those of its section, y that of
/// the row.
contact::Interior grid_interior(const InteriorView& view, const contact::ContactPoints& grid,
                                std::span<const double> p, const contact::TangentialField& t);

}  // namespace tricontact::bem

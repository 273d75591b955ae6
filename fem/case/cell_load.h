#pragma once

#include <array>
#include <vector>

#include "fem/condensed_layer.h"

namespace tricontact::fem {

/// Relative positions (i h, j h), 0 <= i, j < n, along the surface from a square cell of it.
struct CellGrid {
    double size = 0;  ///< h [m]
    int n = 0;
    /// Of a ball, whose pole is the middle of the cell [m]: positions are along great circles, and
    /// components those in frames that these carry along; 0: of a plane.
    double radius = 0;
};

/// What a unit traction on the cell displaces there, i fastest [m/Pa]: along the surface, and out
/// of the body.
struct SurfaceFields {
    int n = 0;
    std::vector<std::array<double, 3>> by_x, by_z;  ///< by traction along x; out of the body
};

/// Half of the body is meshed, y >= 0, a whole number of elements across the cell, and the contact
/// patch is at least as large. Throws contact::InputError, contact::NotConverged; std::logic_error
/// for positions beyond the mesh.
SurfaceFields cell_fields(const LayerProblem& problem, const CellGrid& cells);

/// Between two bodies' fields on the positions that both have [m/Pa].
double largest_difference(const SurfaceFields& a, const SurfaceFields& b);

}  // namespace tricontact::fem

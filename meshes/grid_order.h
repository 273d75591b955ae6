#pragma once

#include "meshes/layer_grid.h"

namespace tricontact::meshes {

/// The mesh renumbered as the grid counts, x fastest, z slowest, its nodes moved to those of the
/// grid (gmsh meets them to some digits only): the same grid gives the same mesh, bit by bit.
/// Hexahedra begin at their lowest corner; faces are sorted by name, then place, and are
/// counter-clockwise from outside. Throws std::runtime_error if it is not a mesh of this grid.
HexMesh in_grid_order(const HexMesh& mesh, const LayerGrid& grid);

}  // namespace tricontact::meshes

#pragma once

#include "meshes/layer_grid.h"

namespace tricontact::meshes {

/// Makes the blocks of the grid, their divisions and the names of their surfaces and volumes in
/// gmsh's current model, lengths in `unit` [m]; within a GmshSession. Ready to be meshed.
void build_blocks(const LayerGrid& grid, double unit);

}  // namespace tricontact::meshes

#pragma once

#include <span>

#include "meshes/hex_mesh.h"

namespace tricontact::fem::distributed {

/// The given hexahedra (increasing) of `mesh` as a mesh of their own, with the names of their
/// faces. Faces where it was cut off, and those without a name, are called free_top: nothing holds
/// or loads them.
meshes::HexMesh part_of(const meshes::HexMesh& mesh, std::span<const int> hexes);

}  // namespace tricontact::fem::distributed

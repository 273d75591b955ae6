#pragma once

#include <string>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Hexahedra and named faces of gmsh's current model, within a GmshSession; nodes, hexahedra and
/// faces in the order of their tags, nodes without a hexahedron left out. `unit` [m] is the length
/// of 1 in the model, `name` what messages call it. Throws contact::InputError: unknown names,
/// hexahedra without one, entities with two, other elements than straight hexahedra.
HexMesh collect_model(double unit, const std::string& name);

/// gmsh's types of elements.
inline constexpr int hexahedron = 5, quadrilateral = 3;

}  // namespace tricontact::meshes

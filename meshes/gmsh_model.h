#pragma once

#include <string>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Hexahedra and named faces of gmsh's current model, within a GmshSession; nodes, hexahedra and
/// faces in the order of their tags, nodes without a hexahedron left out. `unit` [m] is the length
/// of 1 in the model, `name` what messages call it. Throws contact::InputError: unknown names,
/// hexahedra without one, entities with two, other elements than straight hexahedra.
HexMesh collect_model(double unit, const std::string& name);

/// Tag of the physical group: 1, 2, ... in the order of the enumeration.
int physical_tag(Boundary boundary);
int physical_tag(Region region);

/// Makes physical group `name_of(what)` of the entities in the current model.
void add_group(Boundary what, const std::vector<int>& surfaces);
void add_group(Region what, const std::vector<int>& volumes);

}  // namespace tricontact::meshes

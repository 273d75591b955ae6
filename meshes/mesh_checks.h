#pragma once

#include <string>

#include "meshes/hex_mesh.h"

// The parts of verify(), in the order in which they rely on each other. `name` is what messages
// call the mesh. Each throws contact::InputError.
namespace tricontact::meshes {

/// Node numbers exist, hexahedra are neither inverted nor flat.
void check_elements(const HexMesh& mesh, const std::string& name);

/// There is a contact, a base and a layer.
void check_names(const HexMesh& mesh, const std::string& name);

/// No two boundary nodes at one place: blocks that touch share their nodes.
void check_coincident_nodes(const HexMesh& mesh, const FaceTable& table, const std::string& name);

/// At most two hexahedra at a face; every boundary face named, once; no other face named.
void check_faces(const HexMesh& mesh, const FaceTable& table, const std::string& name);

/// The body is in one piece.
void check_connected(const HexMesh& mesh, const FaceTable& table, const std::string& name);

/// Surface in z = 0 with the origin in the contact and the body below, symmetry in y = 0 with the
/// body at y >= 0, base horizontal and away from the contact, contact on the layer.
void check_placement(const HexMesh& mesh, const FaceTable& table, const std::string& name);

/// Nodes of a side, counter-clockwise from outside.
std::array<int, 4> nodes_of(const HexMesh& mesh, const FaceTable::Side& side);

/// Lengths in this proportion to the size of an element are zero: files of few digits pass.
constexpr double negligible = 1e-6;

}  // namespace tricontact::meshes

#pragma once

#include <string>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Surface in z = 0 with the origin in the contact and the body below, symmetry in y = 0 with the
/// body at y >= 0, base horizontal and away from the contact, contact on the layer. `name` is what
/// messages call the mesh. Throws contact::InputError.
void check_placement(const HexMesh& mesh, const FaceTable& table, const std::string& name);

/// Node numbers exist, hexahedra are neither inverted nor flat. Throws contact::InputError.
void check_shape(const HexMesh& mesh, const std::string& name);

/// What touches shares its nodes, every boundary face has one name, no other face has one, and the
/// body is in one piece. Throws contact::InputError.
void check_solid(const HexMesh& mesh, const std::string& name);

/// Lengths in this proportion to the size of an element are zero: files of few digits pass.
constexpr double negligible = 1e-6;

}  // namespace tricontact::meshes

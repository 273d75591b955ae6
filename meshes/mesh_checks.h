#pragma once

#include <string>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Surface in z = 0 with the origin in the contact and the body below, symmetry in y = 0 with the
/// body at y >= 0, base horizontal and away from the contact, contact on the layer. `name` is what
/// messages call the mesh. Throws contact::InputError.
void check_placement(const HexMesh& mesh, const FaceTable& table, const std::string& name);

/// Lengths in this proportion to the size of an element are zero: files of few digits pass.
constexpr double negligible = 1e-6;

}  // namespace tricontact::meshes

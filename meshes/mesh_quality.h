#pragma once

#include <array>
#include <cstddef>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// How good a mesh is.
struct MeshQuality {
    std::size_t n_nodes = 0, n_hexes = 0, n_contact_faces = 0;
    double least_jacobian = 0;  ///< least corner Jacobian over that of a box of the same edges [-]
    double largest_aspect_ratio = 0;      ///< longest edge over shortest, worst element [-]
    double contact_size = 0;              ///< longest edge of a contact face [m]
    std::array<double, 3> low{}, high{};  ///< corners of the bounding box [m]
};
MeshQuality quality(const HexMesh& mesh);

}  // namespace tricontact::meshes

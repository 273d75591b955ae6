#pragma once

#include <array>

#include "meshes/hex_mesh.h"

namespace dealii {
template <int dim, int spacedim>
class Triangulation;
}

namespace tricontact::fem {

/// Makes an empty triangulation (serial or distributed) out of a mesh: cell i is hexahedron i,
/// possibly turned. Boundary ids are those of `meshes::Boundary` plus 1, 0 for faces without a
/// name; material ids are regions.
void triangulate(const meshes::HexMesh& mesh, dealii::Triangulation<3, 3>& triangulation);

/// Refuses a boundary face with id `boundary_id` about `centre` [m] if that is no name: throws
/// contact::InputError.
void require_name(unsigned boundary_id, const std::array<double, 3>& centre);

}  // namespace tricontact::fem

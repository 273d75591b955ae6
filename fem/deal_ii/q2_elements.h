#pragma once

#include <array>
#include <memory>

#include "fem/q2_space.h"

namespace dealii {
template <int dim, int spacedim>
class Triangulation;
}

namespace tricontact::fem::deal_ii {

/// Makes an empty triangulation (serial or distributed) out of a mesh: cell i is hexahedron i,
/// possibly turned. Boundary ids are those of `meshes::Boundary` plus 1, 0 for faces without a
/// name; material ids are regions.
void triangulate(const meshes::HexMesh& mesh, dealii::Triangulation<3, 3>& triangulation);

/// Refuses a boundary face with id `boundary_id` about `centre` [m] if that is no name: throws
/// contact::InputError.
void require_name(unsigned boundary_id, const std::array<double, 3>& centre);

/// As fem::q2_elements(), which calls it where this library is linked.
std::unique_ptr<const Q2Elements> q2_elements(const meshes::HexMesh& mesh, Q2Space& space);

}  // namespace tricontact::fem::deal_ii

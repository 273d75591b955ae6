#pragma once

#include <memory>

#include "fem/q2_space.h"

namespace tricontact::fem {

/// As q2_elements(), with the same numbers, without deal.II, whose libraries take longer to load
/// than a layer's inside to solve for: of a mesh whose hexahedra are all bricks along the axes with
/// named faces on the boundary. Null for any other, which leaves `space` as it is.
std::unique_ptr<const Q2Elements> brick_elements(const meshes::HexMesh& mesh, Q2Space& space);

}  // namespace tricontact::fem

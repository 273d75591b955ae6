#pragma once

#include <vector>

#include "contact/compliances/compliance.h"
#include "fem/matrices.h"
#include "fem/q2_space.h"

namespace tricontact::fem {

/// The contact patch of a mesh as contact sees it.
struct ContactSurface {
    std::vector<int> nodes;         ///< of the mesh, per contact point
    contact::ContactPoints points;  ///< areas: row sums of the mass, doubled where `mirrored`
    SparseMatrix mass;              ///< consistent, lower triangle [m^2] (mirrored: half of it)
};

/// On a regular patch x runs fastest; else the points are sorted by y, then x. Throws
/// contact::InputError when there is no contact face, or one so distorted that a row sum of the
/// mass is not positive.
ContactSurface contact_surface(const Q2Space& space);

}  // namespace tricontact::fem

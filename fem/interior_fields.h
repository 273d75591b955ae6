#pragma once

#include <array>
#include <vector>

#include "contact/solvers/interior.h"
#include "fem/element.h"
#include "fem/q2_space.h"

namespace tricontact::fem {

/// Displacement of every node [m].
using NodalDisplacement = std::vector<std::array<double, 3>>;

/// Points, displacements, stresses and energies of the modelled body; forces are left to the
/// caller. Points on the interface of two regions appear once for each. Stresses come from the
/// 2 x 2 x 2 Gauss points, where those of Q2 elements are most accurate (Barlow 1976), linearly
/// extrapolated to the nodes and averaged over the elements of a region.
contact::Interior interior_fields(const Q2Space& space,
                                  const std::array<Moduli, meshes::n_regions>& moduli,
                                  const NodalDisplacement& displacement);

}  // namespace tricontact::fem

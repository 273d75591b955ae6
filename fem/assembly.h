#pragma once

#include <array>
#include <vector>

#include "contact/solvers/interior.h"
#include "fem/discretisation.h"
#include "fem/element.h"
#include "fem/q2_space.h"

namespace tricontact::fem {

/// `moduli` per region.
AssembledStiffness assemble(const Q2Space& space, const Unknowns& unknowns,
                            const std::array<Moduli, meshes::n_regions>& moduli);

/// Sum over all held components of K u in each direction: the force of what holds them [N].
/// `displacement` per node [m].
std::array<double, 3> held_forces(const Q2Space& space, const Unknowns& unknowns,
                                  const std::array<Moduli, meshes::n_regions>& moduli,
                                  const std::vector<std::array<double, 3>>& displacement);

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

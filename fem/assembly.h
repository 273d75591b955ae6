#pragma once

#include <array>
#include <vector>

#include "fem/discretisation.h"
#include "fem/element.h"
#include "fem/q2_space.h"
#include "fem/unknowns.h"

namespace tricontact::fem {

/// `moduli` per region.
AssembledStiffness assemble(const Q2Space& space, const Unknowns& unknowns,
                            const std::array<Moduli, meshes::n_regions>& moduli);

/// Sum over all held components of K u in each direction: the force of what holds them [N].
/// `displacement` per node [m].
std::array<double, 3> held_forces(const Q2Space& space, const Unknowns& unknowns,
                                  const std::array<Moduli, meshes::n_regions>& moduli,
                                  const std::vector<std::array<double, 3>>& displacement);

}  // namespace tricontact::fem

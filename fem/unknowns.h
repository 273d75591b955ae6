#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fem/layer_problem.h"
#include "fem/q2_space.h"

namespace tricontact::fem {

/// Numbering of the free displacement components: interior first, then the contact patch, there x
/// of all nodes, then y, then z.
struct Unknowns {
    int n = 0, n_interior = 0;
    std::vector<std::array<int, 3>> of_node;  ///< per node and direction; -1: held
    std::vector<int> node_of_unknown, direction_of_unknown;
    std::vector<int> of_contact;  ///< c * n + i less n_interior, or -1: see Discretisation
};

/// Bit c: displacement c is held.
using Directions = std::uint8_t;
Directions held_on(meshes::Boundary boundary, contact::Case::Base base, contact::Case::Sides sides);
/// Throws contact::InputError when rigid motions remain with a base or sides in the mesh or not.
void refuse_rigid_motions(bool has_base, bool has_sides, contact::Case::Base base,
                          contact::Case::Sides sides);

/// Held are: the base (bonded: all, frictionless: z), fixed sides (all), the symmetry plane (y).
/// Throws contact::InputError when rigid motions remain.
Unknowns number_unknowns(const Q2Space& space, const std::vector<int>& contact_nodes,
                         contact::Case::Base base, contact::Case::Sides sides);

}  // namespace tricontact::fem

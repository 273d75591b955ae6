#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "contact/solvers/interior.h"
#include "fem/condensed_layer.h"
#include "fem/contact_surface.h"
#include "fem/element.h"
#include "fem/matrices.h"

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

struct AssembledStiffness {
    SparseMatrix matrix;  ///< between the free unknowns, lower triangle [N/m]
    /// Per direction: the sum of K u over all held components of that direction is the dot product
    /// of u with this [N/m].
    std::array<std::vector<double>, 3> held_rows;
};

/// Q2 displacements with a discontinuous linear pressure eliminated per element: the volumetric
/// strain is projected onto {1, x, y, z} of each element, so that K may be huge (Brezzi and Fortin
/// 1991, Q2/P1; no locking, no checkerboard). The stiffness is symmetric positive definite.
///
/// Free unknowns only: interior ones first, those of the contact patch last, there ordered as
/// x of all contact nodes, then y, then z; held components (base, sides, symmetry plane) have none.
class Discretisation {
  public:
    /// Throws contact::InputError when the mesh leaves rigid motions free, has no contact, or
    /// boundary faces without a name.
    explicit Discretisation(const LayerProblem& problem);

    /// Recomputed by each call: the largest part of a discretisation, often needed but once.
    AssembledStiffness assemble() const;
    /// Node (numbered from 0) to which each unknown belongs, for orderings.
    const std::vector<int>& node_of_unknown() const { return unknowns_.node_of_unknown; }
    /// 0 x, 1 y, 2 z.
    const std::vector<int>& direction_of_unknown() const { return unknowns_.direction_of_unknown; }
    int n_unknowns() const { return unknowns_.n; }
    int n_interior() const { return unknowns_.n_interior; }  ///< before the first of the contact

    /// Nodes of the contact patch. On a regular patch x runs fastest and the grid is described;
    /// areas are row sums of the surface mass (doubled where `mirrored`), all positive.
    const contact::ContactPoints& contact_points() const { return surface_.points; }
    /// Unknown of component c of contact node i at c * n + i, from 0 at n_interior(); -1: held.
    const std::vector<int>& contact_unknowns() const { return unknowns_.of_contact; }
    /// Lower triangle of the consistent mass [m^2] between contact nodes (mirrored: half of it).
    const SparseMatrix& contact_mass() const { return surface_.mass; }

    /// Fields inside for the displacements [m] of all free unknowns under the forces [N] on them.
    contact::Interior interior(std::span<const double> displacement,
                               std::span<const double> force) const;

  private:
    Q2Space space_;
    std::array<Moduli, meshes::n_regions> moduli_{};
    ContactSurface surface_;
    Unknowns unknowns_;
};

}  // namespace tricontact::fem

#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "contact/solvers/compliance.h"
#include "contact/solvers/interior.h"
#include "fem/layer_problem.h"
#include "fem/sparse_matrix.h"

namespace tricontact::fem {

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
    ~Discretisation();

    /// Made anew by each call: the largest part of a discretisation, often needed but once.
    AssembledStiffness assemble() const;
    /// Node (numbered from 0) to which each unknown belongs, for orderings.
    const std::vector<int>& node_of_unknown() const;
    const std::vector<int>& direction_of_unknown() const;  ///< 0 x, 1 y, 2 z
    int n_unknowns() const;
    int n_interior() const;  ///< unknowns before the first of the contact patch

    /// Nodes of the contact patch. On a regular patch x runs fastest and the grid is described;
    /// areas are row sums of the surface mass (doubled where `mirrored`), all positive.
    const contact::ContactPoints& contact_points() const;
    /// Unknown of component c of contact node i at c * n + i, from 0 at n_interior(); -1: held.
    const std::vector<int>& contact_unknowns() const;
    /// Lower triangle of the consistent mass [m^2] between contact nodes (mirrored: half of it).
    const SparseMatrix& contact_mass() const;

    /// Fields inside for the displacements [m] of all free unknowns under the forces [N] on them.
    contact::Interior interior(std::span<const double> displacement,
                               std::span<const double> force) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tricontact::fem

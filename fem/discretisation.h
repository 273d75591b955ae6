#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/compliance.h"
#include "contact/interior.h"
#include "fem/layer_problem.h"
#include "fem/sparse_matrix.h"

namespace tricontact::fem {

/// Q2 displacements with a discontinuous linear pressure eliminated per element: the volumetric
/// strain is projected onto {1, x, y, z} of each element, so that K may be huge (Brezzi and Fortin
/// 1991, Q2/P1; no locking, no checkerboard). The stiffness is symmetric positive definite.
///
/// Free unknowns only: interior ones first, those of the contact patch last, there ordered as
/// x of all contact nodes, then y, then z; held components (base, sides, symmetry plane) have none.
class Discretisation {
  public:
    /// Throws contact::InputError when the mesh leaves rigid motions free.
    explicit Discretisation(const LayerProblem& problem);
    ~Discretisation();

    /// Lower triangle of the stiffness [N/m].
    const SparseMatrix& stiffness() const;
    /// Node (numbered from 0 without gaps) to which each unknown belongs, for orderings.
    const std::vector<int>& node_of_unknown() const;
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
    /// Sum over held unknowns of K u in each direction, i.e. the ground's force [N], for this model
    /// (a mirrored one: half of the body).
    std::array<double, 3> base_reaction(std::span<const double> displacement) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tricontact::fem

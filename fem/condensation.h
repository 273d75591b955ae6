#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fem/matrices.h"
#include "fem/single_factor.h"

namespace tricontact::fem {

/// Sparse Cholesky factor of a stiffness whose last unknowns are those of the contact patch:
/// METIS nested dissection (node graph) of the interior, contact unknowns last, CHOLMOD supernodal.
/// The trailing block of the factor is the factor of the Schur complement on the contact patch.
class Condensation {
  public:
    /// Symbolic analysis only. `node_of_unknown`: see Discretisation; the first `n_interior`
    /// unknowns are eliminated. Throws std::bad_alloc.
    Condensation(SparseMatrix stiffness, std::span<const int> node_of_unknown, int n_interior);
    ~Condensation();

    /// Peak of what `factorise` and `compliance` (`ld` rows) will take on top of now [bytes],
    /// predicted from the symbolic factor.
    double predicted_bytes(int ld = 0) const;
    double matrix_bytes() const;  ///< the stiffness, which is there already
    /// Throws std::bad_alloc; contact::NotConverged if the matrix is not positive definite.
    void factorise();
    /// Displacements of the contact unknowns under unit forces on them [m/N], symmetric, by
    /// columns of `ld` entries (0: as many as there are contact unknowns); both triangles filled,
    /// the rest zero. After factorise().
    std::vector<double> compliance(int ld = 0) const;
    /// Solves for all unknowns, with one step of iterative refinement; `forces` [N] may hold
    /// several right-hand sides one after another. After factorise().
    std::vector<double> solve(std::span<const double> forces) const;

    /// The factor in single precision, which has half the size. After factorise().
    SingleFactor single() const;

  private:
    struct Parts;
    std::vector<double> contact_factor(int ld) const;

    std::unique_ptr<Parts> parts_;
};

}  // namespace tricontact::fem

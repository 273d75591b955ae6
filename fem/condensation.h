#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fem/matrices.h"
#include "fem/single_factor.h"

// Static condensation onto the contact patch C; I: the interior (docs/explanation/models/fem.md).
//
//       [ K_II  K_IC ]                    [ L_II       ]
//   K = [            ] = L L',        L = [            ]
//       [ K_CI  K_CC ]                    [ L_CI  L_CC ]
//
//   S = K_CC - K_CI K_II^-1 K_IC = L_CC L_CC',       compliance = S^-1
//
// With the contact unknowns last, L_CC is the trailing block of the factor of K: no second
// factorisation. S^-1 is dense and exact for every contact on the patch, whatever its loads and
// path; that is why it is worth keeping on disk.
//
// The order of I is METIS' nested dissection of the nodes. CHOLMOD would order for itself, but then
// the contact unknowns were not last. The elimination tree is put into postorder, which joins
// columns of equal structure to wide supernodes: dense kernels do the work.

namespace tricontact::fem {

/// Sparse Cholesky factor of a stiffness whose last unknowns are those of the contact patch:
/// METIS nested dissection (node graph) of the interior, contact unknowns last, CHOLMOD supernodal.
/// The trailing block of the factor is the factor of the Schur complement on the contact patch.
class Condensation {
  public:
    /// Symbolic analysis only. `node_of_unknown`: see Discretisation; the first `n_interior`
    /// unknowns are eliminated. Throws std::bad_alloc.
    Condensation(const SparseMatrix& stiffness, std::span<const int> node_of_unknown,
                 int n_interior);
    /// The same in an order that is known, see dissection_order(); the first `n_interior` of it are
    /// eliminated. Unknowns that it lacks are held.
    Condensation(const SparseMatrix& stiffness, std::vector<std::int64_t> order, int n_interior);
    Condensation(Condensation&&) noexcept;
    ~Condensation();

    int n() const;  ///< unknowns of the stiffness, held ones included
    /// The contact unknowns that are not held, as they come in the compliance.
    std::span<const std::int64_t> contact() const;

    /// Peak of what `factorise` and `compliance` will take on top of now [bytes], predicted from
    /// the symbolic factor.
    double predicted_bytes() const;
    double matrix_bytes() const;  ///< the stiffness, which is there already
    /// Throws std::bad_alloc; contact::NotConverged if the matrix is not positive definite.
    void factorise();
    void forget_factor();  ///< what was analysed stays
    bool is_factorised() const;
    /// Displacements of the contact unknowns under unit forces on them [m/N], symmetric, both
    /// triangles filled. After factorise().
    std::vector<double> compliance() const;
    /// Displacements [m] of all unknowns, zero where held, with one step of iterative refinement;
    /// `forces` [N] may hold several right-hand sides one after another. After factorise().
    std::vector<double> solve(std::span<const double> forces) const;

    /// The factor in single precision, which has half the size. After factorise().
    SingleFactor single() const;

  private:
    struct Parts;
    std::vector<double> contact_factor() const;

    std::unique_ptr<Parts> parts_;
};

}  // namespace tricontact::fem

#pragma once

#include <array>
#include <span>
#include <vector>

#include "fem/block/fast_diagonalisation.h"
#include "fem/block/mixed_operator.h"

namespace tricontact::fem {

/// Displacements and pressures of a block under forces, without a factor: MINRES (Paige and
/// Saunders 1975) on the mixed form, preconditioned by FastDiagonalisation and the mass of the
/// pressures. Memory and work of an iteration grow with the unknowns; their number hardly depends
/// on size, grading and K/G.
class BlockSolver {
  public:
    BlockSolver(const BlockGrid& grid, int n_threads);

    const MixedOperator& mixed() const { return operator_; }

    /// Adds to x, the start, what solves to `tolerance` [-] of the forces, in the norm of the
    /// preconditioner. `forces` [N] as x: u_x of all nodes, u_y, u_z, then zeros. Returns the
    /// iterations. Throws contact::NotConverged.
    int solve(std::span<const double> forces, double tolerance, std::vector<double>& x);

    /// What it takes for such a block [bytes].
    static double bytes(const BlockGrid& grid);

  private:
    void precondition(std::span<const double> r, std::span<double> z);
    double dot(std::span<const double> a, std::span<const double> b) const;

    MixedOperator operator_;
    FastDiagonalisation shear_;
    std::vector<double> pressure_scale_;
};

}  // namespace tricontact::fem

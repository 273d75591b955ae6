#pragma once

#include <array>
#include <span>
#include <vector>

#include "fem/block/fast_diagonalisation.h"
#include "fem/block/mixed_operator.h"

namespace tricontact::fem {

/// Displacements and pressures of a block under forces, without a factor: conjugate gradients of
/// Bramble and Pasciak (1988) on the mixed form, preconditioned by FastDiagonalisation and then the
/// mass of the pressures. Memory and work of an iteration grow with the unknowns; their number
/// does not depend on the size of elements and K/G, and little on grading.
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
    struct Iterates;
    void precondition(double weight, std::span<const double> r, std::span<double> z);
    void set_residual(std::span<const double> forces, const std::vector<double>& x, Iterates& it);
    int iterate_until(double goal, int most, Iterates& it, std::vector<double>& x);
    bool iterate(Iterates& it, std::vector<double>& x);
    double norm(const Iterates& it) const;

    MixedOperator operator_;
    FastDiagonalisation shear_;
    std::vector<double> scale_, without_bulk_;  // of pressures
};

}  // namespace tricontact::fem

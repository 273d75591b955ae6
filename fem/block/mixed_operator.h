#pragma once

#include <span>
#include <vector>

#include "fem/block/block_grid.h"

namespace tricontact::fem {

/// Displacements and pressures of a block: the elements of element.h with their pressure kept.
///
///   [ A  B' ] [ u ]   [ f ]     A: int 2 G dev eps : dev eps,  B: int psi_m div u,
///   [ B  -C ] [ p ] = [ 0 ]     C: int psi_m psi_n / K,        p = K P div u
///
/// psi = {1, xi, eta, zeta}, -1 to 1 over the brick: C is a diagonal, and 0 for K = infinity. A
/// vector has u_x of all nodes, u_y, u_z, then p_0 of all elements to p_3. Held components are
/// zero.
class MixedOperator {
  public:
    MixedOperator(const BlockGrid& grid, int n_threads);

    std::size_t size() const { return 3 * n_nodes_ + 4 * n_elements_; }
    std::size_t n_nodes() const { return n_nodes_; }
    const BlockGrid& grid() const { return grid_; }
    int n_threads() const { return n_threads_; }

    /// to = operator x; x is zero where held, and so is `to`.
    void apply(std::span<const double> x, std::span<double> to) const;
    /// As apply(), with the pressures that leave (B u - `x`'s pressures) / scale of their
    /// equations, element by element: to = (A u + B' q, q), q = (B u - x_p) / scale.
    void apply_eliminated(std::span<const double> x, std::span<const double> scale,
                          std::span<double> to) const;
    /// Pressures of the elements among the unknowns x [Pa].
    std::array<double, 4> pressure(std::span<const double> x, std::size_t element) const {
        std::array<double, 4> p{};
        for (std::size_t m = 0; m < 4; ++m) p[m] = x[3 * n_nodes_ + m * n_elements_ + element];
        return p;
    }
    /// Forces [N] of what holds the components that are held, by direction, for these x.
    std::array<double, 3> held_forces(std::span<const double> x) const;
    /// Zeros where components are held.
    void clear_held(std::span<double> x) const;
    /// Of each pressure int psi_m^2 (share/G + of_bulk/K), less of linear ones in the first term:
    /// with of_bulk = 1 about B A^-1 B' + C.
    std::vector<double> pressure_scale(double share, double of_bulk) const;

  private:
    void apply_free(std::span<const double> x, const double* scale, std::span<double> to) const;
    void apply_row(int e_y, int e_z, const double* x, const double* scale, double* to) const;
    template <class Visit>
    void for_held(Visit visit) const;

    BlockGrid grid_;
    int n_threads_;
    std::size_t n_nodes_, n_elements_;
    std::vector<double> edges_x_;  // of elements [m]
};

}  // namespace tricontact::fem

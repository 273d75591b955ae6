#pragma once

#include <span>
#include <vector>

#include "fem/block/block_grid.h"

namespace tricontact::fem {

/// Solves with the diagonal blocks of the shear stiffness of a block, those of a component with
/// itself, which are
///
///   a_x K_x (x) M_y (x) M_z + a_y M_x (x) K_y (x) M_z + a_z M_x (x) M_y (x) K_z,
///
/// a = 4/3 along the component, 1 across, M and K masses and stiffnesses of one direction, those of
/// z weighted by the shear modulus: exactly, by the eigenvectors of each direction (Lynch, Rice and
/// Thomas 1964), however bricks are graded.
class FastDiagonalisation {
  public:
    /// `weight` [-]: a along the component.
    FastDiagonalisation(const BlockGrid& grid, int n_threads, double weight = 4. / 3);

    /// The component c of all nodes; zero where held.
    void solve(int c, std::span<const double> right, std::span<double> to);

  private:
    /// Eigenvectors by columns, orthonormal in the mass, 0 where held, and their eigenvalues.
    struct Modes {
        int n = 0;
        std::vector<double> vectors, values;
    };
    static std::size_t scratch_of_thread(const BlockGrid& grid);
    static Modes modes_of(const BlockAxis& axis, const std::vector<double>& stiff, int component);

    std::array<std::array<Modes, 3>, 3> modes_;  // of component, direction
    double weight_;
    int n_threads_;
    std::vector<double> scratch_, of_threads_;
};

}  // namespace tricontact::fem

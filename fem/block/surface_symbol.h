#pragma once

#include <complex>
#include <memory>

#include "fem/block/block_grid.h"

namespace tricontact::fem {

/// Stiffness of the surface of equal columns of elements, side by side without end, at wave
/// vectors: of their four nodes on the surface, corner (0), edges along x (1) and y (2), centre
/// (3), in three directions.
class SurfaceSymbol {
  public:
    static constexpr int size = 12;  ///< 3 * kind + direction
    /// By columns, Hermitian [N/m].
    using Matrix = std::array<std::complex<double>, size * size>;

    /// Columns of the edges `edge_x`, `edge_y` [m] on the base that `grid` has.
    SurfaceSymbol(const BlockGrid& grid, double edge_x, double edge_y);
    ~SurfaceSymbol();

    /// Compliance [m/N] where the column ahead along x is displaced by exp(i phase_x) times what
    /// this one is, and alike along y. `drift`: stiffness [N/m] of a node of the base that slides
    /// freely.
    Matrix compliance(double phase_x, double phase_y, double drift) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace tricontact::fem

#pragma once

#include <memory>
#include <optional>

#include "bem/grid_convolution.h"
#include "contact/solvers/normal_grid.h"

namespace tricontact::bem {

/// Normal displacements by a convolution, and on coarser grids by its Galerkin projections: a
/// square's pressure times w = (1/2, 1, 1/2) in x and in y is that of cells, so that with
/// w^ = 2 cos^2(theta/2) the symbol at the wave numbers m of half the period P is
///   K_c(m) = sum over a, b = 0, 1 of cos^2(theta_x/2) cos^2(theta_y/2) K(m_x + a P/2, m_y + b
///   P/2).
class NormalLevel final : public contact::NormalGrid {
  public:
    using Symbol = GridConvolution::Symbol;

    /// The finest. `convolution` and `symbol` outlive it.
    NormalLevel(const GridConvolution& convolution, const Symbol& symbol, double cell_area);
    NormalLevel(const NormalLevel&) = delete;

    int n_x() const override { return convolution_.n_x(); }
    int n_y() const override { return convolution_.n_y(); }
    double cell_area() const override { return cell_area_; }
    int n_threads() const override { return convolution_.n_threads(); }
    void displace(std::span<const double> p, std::span<double> u_z) const override {
        convolution_.apply<1, 1>({{{&symbol_}}}, {p}, {u_z});
    }
    void precondition(std::span<const double> r, std::span<double> z) const override {
        (bare_ ? *bare_ : convolution_).apply<1, 1>({{{&inverse_}}}, {r}, {z});
    }
    std::unique_ptr<const NormalGrid> coarser() const override;

  private:
    struct Projection {
        GridConvolution convolution;
        Symbol symbol;
    };
    NormalLevel(std::unique_ptr<const Projection> projection, double cell_area);
    void make_inverse();

    std::unique_ptr<const Projection> projection_;  // of a finer one, or null
    const GridConvolution& convolution_;
    const Symbol& symbol_;
    double cell_area_;
    std::optional<GridConvolution> bare_;  // without padding
    Symbol inverse_;
};

}  // namespace tricontact::bem

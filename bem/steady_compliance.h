#pragma once

#include <array>
#include <vector>

#include "bem/grid_convolution.h"
#include "bem/quadrants.h"
#include "contact/compliances/steady_compliance.h"
#include "contact/creep_modes.h"

namespace tricontact::bem {

/// Relaxing bodies that move on steadily below tractions which are constant on the cells of a grid.
/// Their coefficients are those of elastic bodies that have crept along the way, once and for all
/// (contact::CreepAlongWay): the steady state is one convolution, and what lies far ahead of the
/// contact needs no cells.
class SteadyGridCompliance final : public contact::SteadyCompliance {
  public:
    /// `bodies`: elastic ones, asked for at x, y >= 0 only, that `weights` combine to `creep`, see
    /// contact::CreepModes. `speed` [m/s]. `coupled`: use the coefficients between normal and
    /// tangential.
    SteadyGridCompliance(const std::vector<CellInfluence>& bodies, const contact::CreepModes& modes,
                         double speed, contact::ContactPoints grid, bool coupled);

    const contact::ContactPoints& points() const override { return grid_; }
    bool is_coupled() const override { return coupled_; }
    double local_tangential() const override { return local_; }
    void normal(std::span<const double> p, std::span<double> u_z) const override;
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override;
    void tangential_from_normal(std::span<const double> p,
                                contact::TangentialField& u) const override;
    void normal_from_tangential(const contact::TangentialField& t,
                                std::span<double> u_z) const override;
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override;
    void precondition_normal(std::span<const double> r, std::span<double> z) const override;

  private:
    /// Of a kernel the part that is even under (x, y) -> (-x, -y), and the odd one.
    struct Symbols {
        GridConvolution::Symbol even, odd;
    };
    enum Component { xx, xy, yy, xz, yz, zz, n_components };
    /// Coefficients at relative positions of i cells of either sign along x and j >= 0 along y.
    struct Table;

    Table crept(const std::vector<CellInfluence>& bodies, const contact::CreepModes& modes,
                double speed) const;

    contact::ContactPoints grid_;
    bool coupled_;
    double local_ = 0;
    GridConvolution linear_;    // zero-padded
    GridConvolution periodic_;  // on the bare grid, for the preconditioners
    std::array<Symbols, n_components> kernels_;
    GridConvolution::Symbol2 inverse_tangential_;
    GridConvolution::Symbol inverse_normal_;
    mutable contact::TangentialField odd_;  // what one of both parts displaces
};

}  // namespace tricontact::bem

#pragma once

#include "bem/grid_convolution.h"
#include "bem/influence_file.h"
#include "bem/periodic_influence.h"
#include "contact/solvers/compliance.h"

namespace tricontact::bem {

/// Layers and a rigid indenter, or two half-spaces, in each of equal squares that fill the plane:
/// one square, its tractions constant on n x n cells, displacements at their centres; FFT (Stanley
/// & Kato 1997). Its mean displacement is that under a uniform traction. All of it compressed at nu
/// = 1/2 would be at infinite stiffness: then the pressure is known up to a constant only. So it is
/// on half-spaces, whose mean displacement is zero by definition.
class PeriodicCompliance final : public contact::Compliance {
  public:
    /// `grid` is square and covers one period. Throws contact::InputError as PeriodicInfluence.
    PeriodicCompliance(const theory::LayerStack& stack, contact::ContactPoints grid, int n_threads);

    PeriodicCompliance(const contact::MaterialPair& half_spaces, contact::ContactPoints grid,
                       int n_threads);

    const contact::ContactPoints& points() const override { return grid_; }
    bool is_coupled() const override { return coupled_; }
    void normal(std::span<const double> p, std::span<double> u_z) const override;
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override;
    void tangential_from_normal(std::span<const double> p,
                                contact::TangentialField& u) const override;
    void normal_from_tangential(const contact::TangentialField& t,
                                std::span<double> u_z) const override;
    double local_tangential() const override { return local_tangential_; }
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override;

    /// The periodic influence of one cell at all positions 0 <= i, j < n within the period: what
    /// lies beyond half of it stands for the negative positions, signs included.
    InfluenceTable influence() const;

  private:
    PeriodicCompliance(const PeriodicInfluence& influence, contact::ContactPoints grid,
                       bool coupled, int n_threads);

    contact::ContactPoints grid_;
    bool coupled_;
    GridConvolution convolution_;
    GridConvolution::Symbol normal_;
    GridConvolution::Symbol2 tangential_, inverse_;
    GridConvolution::OddSymbol2 from_normal_;
    double local_tangential_ = 0;
};

}  // namespace tricontact::bem

#pragma once

#include <optional>

#include "bem/grid_convolution.h"
#include "contact/compliance.h"
#include "contact/material.h"

namespace tricontact::bem {

/// Two elastic half-spaces (or one and a rigid body) under piecewise constant tractions on a
/// regular grid, displacements at the cells' centres; zero-padded FFT convolution (Ju & Farris
/// 1996; Liu, Wang & Liu 2000). Tangential-normal cross terms are left out: see `is_coupled`.
class HalfSpaceCompliance final : public contact::Compliance {
  public:
    HalfSpaceCompliance(const contact::MaterialPair& materials, contact::ContactPoints grid,
                        int n_threads);

    const contact::ContactPoints& points() const override { return grid_; }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override;
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override;
    double local_tangential() const override;
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override;

  private:
    void prepare_tangential() const;

    contact::MaterialPair materials_;
    contact::ContactPoints grid_;
    int n_threads_;
    GridConvolution linear_;    // zero-padded
    GridConvolution periodic_;  // on the bare grid, for the preconditioner
    GridConvolution::Symbol normal_;
    // Made when first needed: normal contact alone takes half the memory.
    mutable std::optional<GridConvolution::Symbol2> tangential_, inverse_;
};

}  // namespace tricontact::bem

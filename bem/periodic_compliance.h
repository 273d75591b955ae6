#pragma once

#include <vector>

#include "bem/grid_compliance.h"
#include "contact/substrates/material.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// Fourier coefficients [m/Pa] of the displacement at the cells' centres that one loaded cell in
/// every period makes; of those with z and another direction the imaginary part. Of layers on rigid
/// ground, or two half-spaces, under tractions that are uniform on squares and periodic in x and y,
/// n squares in a period L. At the wave vector k = 2 pi m/L of the grid
///   K(m) = sum over aliases q of C(k) sin(k_x h/2)/(k_x h/2) sin(k_y h/2)/(k_y h/2),
///   k = 2 pi (m + q n)/L,
/// C the compliance of theory/layer/layer_compliance.h, of half-spaces that of an infinitely thick
/// layer, ~ 1/k. Aliases are what makes a sum of sines a square; they alternate in sign, and their
/// sum is ended by Euler's averages to about 1e-7 of K. At m = 0 there are none: K is the uniformly
/// loaded layers', b (1 - 2 nu)/(2 G (1 - nu)) of each and b/G. The cell is then as stiff as an
/// oedometer; at nu = 1/2 not at all compressible. A half-space gives way without bound; its K is
/// zero there, so that displacements are those from the mean plane of the displaced surface.
class PeriodicInfluence {
  public:
    /// `spacing`: h [m]; the period is `n` of them. Throws contact::InputError if the layers' mean
    /// displacement has no bound: on a frictionless base or an elastic ground.
    PeriodicInfluence(const theory::LayerStack& stack, double spacing, int n, int n_threads);
    /// Of both half-spaces, substrate minus indenter.
    PeriodicInfluence(const contact::MaterialPair& half_spaces, double spacing, int n,
                      int n_threads);

    /// At the wave numbers 2 pi m_x/L, 2 pi m_y/L, of either sign, |m| <= n/2.
    InfluenceCoefficients at(int m_x, int m_y) const;

  private:
    template <class Sum>
    void fill(const InfluenceCoefficients& uniform, int n_threads, Sum sum);

    int n_, n_quadrant_;
    std::vector<InfluenceCoefficients> quadrant_;  // m_x, m_y >= 0, m_x fastest
};

/// Layers and a rigid indenter, or two half-spaces, in each of equal squares that fill the plane:
/// one square, its tractions constant on n x n cells, displacements at their centres; FFT (Stanley
/// & Kato 1997). Its mean displacement is that under a uniform traction. All of it compressed at nu
/// = 1/2 would be at infinite stiffness: then the pressure is known up to a constant only. So it is
/// on half-spaces, whose mean displacement is zero by definition.
class PeriodicCompliance final : public ConvolvedCompliance {
  public:
    /// `grid` is square and covers one period. Throws contact::InputError as PeriodicInfluence.
    PeriodicCompliance(const theory::LayerStack& stack, contact::ContactPoints grid, int n_threads,
                       const contact::Interface& interface = {});

    PeriodicCompliance(const contact::MaterialPair& half_spaces, contact::ContactPoints grid,
                       int n_threads, const contact::Interface& interface = {});

    double local_tangential() const override { return local_tangential_; }

    /// The periodic influence of one cell at all positions 0 <= i, j < n within the period: what
    /// lies beyond half of it stands for the negative positions, signs included.
    InfluenceTable influence() const;

  private:
    PeriodicCompliance(const PeriodicInfluence& influence, contact::ContactPoints grid,
                       bool coupled, int n_threads, const contact::Interface& interface);

    double local_tangential_ = 0;
};

}  // namespace tricontact::bem

#pragma once

#include <vector>

#include "contact/substrates/material.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// Fourier coefficients [m/Pa] of the displacement at the cells' centres that one loaded cell in
/// every period makes, z into the substrate, tractions on it: zz is u_z per pressure, of those
/// with z and another direction the imaginary part.
struct PeriodicCoefficients {
    double zz, xx, xy, yy, xz, yz;
};

/// Layers on rigid ground, or two half-spaces, under tractions that are uniform on squares and
/// periodic in x and y, n squares in a period L. At the wave vector k = 2 pi m/L of the grid
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
    PeriodicCoefficients at(int m_x, int m_y) const;

  private:
    template <class Sum>
    void fill(const PeriodicCoefficients& uniform, int n_threads, Sum sum);

    int n_, n_quadrant_;
    std::vector<PeriodicCoefficients> quadrant_;  // m_x, m_y >= 0, m_x fastest
};

}  // namespace tricontact::bem

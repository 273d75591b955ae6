#pragma once

#include <vector>

#include "theory/layer_stack.h"

namespace tricontact::bem {

/// Fourier coefficients [m/Pa] of the displacement at the cells' centres that one loaded cell in
/// every period makes, z into the substrate, tractions on it: zz is u_z per pressure, of those
/// with z and another direction the imaginary part.
struct PeriodicCoefficients {
    double zz, xx, xy, yy, xz, yz;
};

/// Layers on rigid ground under tractions that are uniform on squares and periodic in x and y, n
/// squares in a period L. At the wave vector k = 2 pi m/L of the grid
///   K(m) = sum over aliases q of C(k) sin(k_x h/2)/(k_x h/2) sin(k_y h/2)/(k_y h/2),
///   k = 2 pi (m + q n)/L,
/// C the layers' compliance of theory/layer_compliance.h. Aliases are what makes a sum of sines a
/// square; they alternate in sign, and their sum is ended by Euler's averages to about 1e-7 of K.
/// At m = 0 there are none: K is the uniformly loaded layers', b (1 - 2 nu)/(2 G (1 - nu)) of each
/// and b/G. The cell is then as stiff as an oedometer; at nu = 1/2 not at all compressible.
class PeriodicInfluence {
  public:
    /// `spacing`: h [m]; the period is `n` of them. Throws contact::InputError if the layers' mean
    /// displacement has no bound: on a frictionless base or an elastic ground.
    PeriodicInfluence(const theory::LayerStack& stack, double spacing, int n, int n_threads);

    /// At the wave numbers 2 pi m_x/L, 2 pi m_y/L, of either sign, |m| <= n/2.
    PeriodicCoefficients at(int m_x, int m_y) const;

  private:
    int n_, n_quadrant_;
    std::vector<PeriodicCoefficients> quadrant_;  // m_x, m_y >= 0, m_x fastest
};

}  // namespace tricontact::bem

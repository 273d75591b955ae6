#pragma once

#include <vector>

#include "theory/layer/layer_stack.h"

namespace tricontact::mdr {

/// What a layer takes from the half-space's independent springs: on a line, the load q(t) raises
/// the surface at x against the half-space's by 1/E* ∫ K(x - t) q(t) dt (tangentially 1/G* and
/// K_t),
///   K(s) = 1/pi ∫_0^inf [1 - C/C_half-space](k) cos(k s) dk,
/// C33 for K, exact for axisymmetric pressure (theory/layer/layer_equation.h). K_t has the mean of
/// C11 and C22, which is exact for the mean over the circle of u_x under tractions along x that
/// depend on the distance from the axis alone; what varies as the cosine and sine of 2 theta is
/// left out.
struct LayerKernel {
    std::vector<double> normal;      ///< K at the distances 0, h, 2h, ... [1/m]
    std::vector<double> tangential;  ///< K_t; empty on a frictionless base, where it diverges
};

/// `n` values at the distance `spacing` [m], to about 1e-14 of 1/b. Throws contact::InputError.
LayerKernel layer_kernel(const theory::LayerStack& stack, double spacing, int n);

}  // namespace tricontact::mdr

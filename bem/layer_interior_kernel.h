#pragma once

#include <array>
#include <vector>

#include "theory/half_space_interior.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// Displacements and stresses inside layers under a point force on their surface, less those in a
/// half-space of the top layer (below that layer: its continuation). With f(k, z) the difference of
/// an amplitude of interior_waves.h, each is a sum of
///   1/(2 pi) ∫ k f Jm(kr) dk  times  cos(m theta) or sin(m theta),  m = 0, 1, 2, 3.
/// The difference falls as exp(-k (2 b - z)): it is finite everywhere.
class LayerInteriorKernel {
  public:
    /// At `depths` [m]: increasing, from 0 to the thickness of all layers, and for 0 <= r <=
    /// `reach` [m]; to about 1e-9 of the half-space at that thickness. Layers on a frictionless
    /// base are held as LayerKernel holds them. Throws contact::InputError.
    LayerInteriorKernel(const theory::LayerStack& stack, const std::vector<double>& depths,
                        double reach);

    /// Adds `force` [N/Pa = m^2] times the response at (x, y) from the force and depths[level].
    void add(std::size_t level, double x, double y, double force,
             theory::InteriorResponse& sum) const;

    /// Radial functions: six of pressure, nine of a tangential force.
    using Values = std::array<double, 15>;

  private:
    Values at(std::size_t level, double r) const;

    double unit_;                              // thickness of the top layer [m]
    std::vector<std::vector<Values>> tables_;  // per depth, over asinh(r/unit)
};

}  // namespace tricontact::bem

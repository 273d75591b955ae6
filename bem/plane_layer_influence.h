#pragma once

#include <optional>
#include <vector>

#include "bem/influence.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// The same stack. Throws contact::InputError, also for layers on an elastic half-space, which
/// displaces without bound under any line load.
const theory::LayerStack& checked_in_plane_strain(const theory::LayerStack& stack);

/// Influence coefficients of layers in plane strain (u_y: antiplane) under a traction that is
/// uniform on an endless strip across x, displacements relative to an elastic or rigid indenter:
///   K_zz, K_xx, K_yy = (1/pi) ∫ C33, C11, C22 cos(k s) dk,  K_xz = -(1/pi) ∫ C13 sin(k s) dk
/// over the strip (see layer_compliance.h). Of each C the half-space's C0 (1 - exp(-2 k b))/k, b
/// the thickness of the top layer, is integrated in closed form: what is left is smooth in k.
///
/// A rigid ground is the datum of the displacements. What has none: layers that nothing holds from
/// gliding on their ground are held as in LayerKernel, frictionless_hold thicknesses away on either
/// side; an elastic indenter is a half-space under a strip of the finite length `width_y`.
class PlaneLayerInfluence {
  public:
    /// `indenter` empty: rigid. `width_x`: of the strip [m], `width_y`: its length [m]. `reach`:
    /// largest distance asked for [m]. Throws contact::InputError as
    /// checked_in_plane_strain.
    PlaneLayerInfluence(const theory::LayerStack& stack,
                        const std::optional<contact::Material>& indenter, double width_x,
                        double width_y, double reach);

    /// All coefficients at the distance x [m] from the strip's centre line.
    InfluenceCoefficients at(double x) const;

  private:
    /// Weights of the strip in the four integrals.
    struct StripWave {
        double k;
        double normal, along, across, coupling;
    };

    InfluenceCoefficients closed_part(double x) const;

    double half_width_, hold_;       // hold_: 0 where the ground holds the layers
    double twice_thickness_;         // 2 b
    theory::LayerCompliance scale_;  // C0/pi of the top layer's half-space [1/Pa]
    std::vector<StripWave> waves_;
    std::optional<RectangleInfluence> indenter_;
};

}  // namespace tricontact::bem

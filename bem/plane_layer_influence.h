#pragma once

#include <array>
#include <optional>
#include <vector>

#include "bem/influence.h"
#include "theory/half_space_interior.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

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
    /// largest distance asked for [m]. Throws contact::InputError, also for layers on an elastic
    /// half-space, which displaces without bound under any line load.
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

/// Displacements and stresses inside layers in plane strain (along y: antiplane) per uniform
/// traction on an endless strip across x. With the amplitudes f(k, z) of layer_stack.h each is
///   (1/pi) ∫ f cos(k s) dk  or  (1/pi) ∫ f sin(k s) dk  over the strip.
/// The part of the top layer's half-space is a closed form, of the logarithmic potentials of a
/// line; what is left falls as exp(-k (2 b - z)). Displacements count as those of
/// PlaneLayerInfluence, which is this at z = 0.
class PlaneInteriorInfluence {
  public:
    /// `width`: of the strip [m]. `depths`: increasing, >= 0, at most the thickness of all layers
    /// [m]. `reach`: largest distance asked for [m]. Throws contact::InputError as
    /// PlaneLayerInfluence does.
    PlaneInteriorInfluence(const theory::LayerStack& stack, double width,
                           std::vector<double> depths, double reach);

    /// At the distance x [m] from the strip's centre line and depths[level]; the point must not lie
    /// on an edge of the strip. [m/Pa] and [-].
    theory::InteriorResponse at(std::size_t level, double x) const;

    /// Fields that are not zero throughout.
    static constexpr std::size_t n_fields = 15;
    using Amplitudes = std::array<double, n_fields>;

  private:
    struct StripWave {
        double k, factor;                   // its weight in integrals over strip and k
        std::vector<Amplitudes> amplitude;  // per depth, factor included
    };

    void hold_at(double distance, const theory::LayerStack& stack);
    theory::InteriorResponse closed_part(double depth, double x) const;

    contact::Material top_;
    double half_width_;
    double datum_;  // distance at which a line's logarithmic displacement is zero [m]
    std::vector<double> depths_;
    std::vector<StripWave> waves_;
    std::array<double, 3> rigid_{};  // displacement of all along each load [m/Pa]
};

}  // namespace tricontact::bem

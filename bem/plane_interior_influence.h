#pragma once

#include <array>
#include <vector>

#include "theory/half_space_interior.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// Displacements and stresses inside layers in plane strain (along y: antiplane) per uniform
/// traction on an endless strip across x. With the amplitudes f(k, z) of interior_waves.h each is
///   (1/pi) ∫ f cos(k s) dk  or  (1/pi) ∫ f sin(k s) dk  over the strip.
/// The part of the top layer's half-space is a closed form, of the logarithmic potentials of a
/// line; what is left falls as exp(-k (2 b - z)). Displacements count as those of
/// PlaneLayerInfluence, which is this at z = 0.
class PlaneInteriorInfluence {
  public:
    /// `width`: of the strip [m]. `depths`: increasing, >= 0, at most the thickness of all layers
    /// [m]. `reach`: largest distance asked for [m]. Throws contact::InputError as
    /// checked_in_plane_strain.
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

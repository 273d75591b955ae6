#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/base/gauss_legendre.h"
#include "contact/base/vector2.h"
#include "theory/half_space_interior.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// Displacements and stresses inside layers under a point force on their surface, less those in a
/// half-space of the top layer (below that layer: its continuation). With f(k, z) the difference of
/// an amplitude of layer_stack.h, each is a sum of
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

/// What is below the surface: layers, or (`layers` empty) a half-space.
struct InteriorBody {
    explicit InteriorBody(const contact::Material& half_space);
    explicit InteriorBody(theory::LayerStack stack, bool under_strips = false);

    contact::Material material;  ///< of the half-space or the uppermost layer
    std::optional<theory::LayerStack> layers;
    bool plane_strain = false;  ///< of layers, under strips: see PlaneInteriorInfluence
};

/// Displacements and stresses inside per uniform traction on a rectangle of the surface: closed
/// forms of the half-space (Love 1929 for pressure; the same integrals of Cerruti's solution), for
/// layers plus the difference between both, Hankel integrals as in LayerKernel.
class InteriorInfluence {
  public:
    /// `widths`: sides of the rectangle [m]. `depths`: increasing, >= 0, of layers at most their
    /// thickness [m]. `reach`: largest distance asked for [m]. Throws contact::InputError.
    InteriorInfluence(InteriorBody body, contact::Vector2 widths, std::vector<double> depths,
                      double reach);

    /// At (x, y) [m] from the rectangle's centre and depths[level]; the point must not lie on its
    /// edge. [m/Pa] and [-].
    theory::InteriorResponse at(std::size_t level, double x, double y) const;

  private:
    InteriorBody body_;
    contact::Vector2 widths_;
    std::vector<double> depths_;
    // What layers add to the half-space, and where in the rectangle its kernel is taken.
    std::optional<LayerInteriorKernel> difference_;
    contact::QuadratureRule rule_;
};

}  // namespace tricontact::bem

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "contact/vector2.h"
#include "theory/half_space_interior.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::bem {

/// What is below the surface: layers, or (`layers` empty) a half-space of `material`.
struct InteriorBody {
    contact::Material material;
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
    ~InteriorInfluence();

    /// At (x, y) [m] from the rectangle's centre and depths[level]; the point must not lie on its
    /// edge. [m/Pa] and [-].
    theory::InteriorResponse at(std::size_t level, double x, double y) const;

  private:
    struct Difference;
    InteriorBody body_;
    contact::Vector2 widths_;
    std::vector<double> depths_;
    std::unique_ptr<Difference> difference_;
};

}  // namespace tricontact::bem

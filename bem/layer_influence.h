#pragma once

#include <memory>
#include <optional>

#include "bem/influence.h"
#include "bem/layer_kernel.h"
#include "theory/line_load.h"

namespace tricontact::bem {

/// Points and weights on (-1/2, 1/2) that integrate what layers add over a cell. It varies over the
/// thickness b: two points per direction leave (h/b)^4/4000 of it.
theory::QuadratureRule cell_rule(double width_over_thickness);

/// Influence coefficients of layers under a uniform traction on a rectangle, displacements relative
/// to an elastic or rigid indenter: closed forms of the half-space plus the layers' difference
/// kernel, integrated by Gauss points.
class LayerInfluence {
  public:
    /// `indenter` empty: rigid. `width_x`, `width_y`: sides of the rectangle [m]. `reach`: largest
    /// distance asked for [m]. Throws contact::InputError.
    LayerInfluence(const theory::LayerStack& stack,
                   const std::optional<contact::Material>& indenter, double width_x, double width_y,
                   double reach);

    /// All coefficients at (x, y) [m] from the rectangle's centre.
    InfluenceCoefficients at(double x, double y) const;

  private:
    RectangleInfluence half_space_;
    LayerKernel kernel_;
    std::vector<double> points_, weights_;  // of the unit interval (-1/2, 1/2)
    double width_x_, width_y_;
};

}  // namespace tricontact::bem

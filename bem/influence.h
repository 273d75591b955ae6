#pragma once

#include "contact/substrates/material.h"

namespace tricontact::bem {

/// Displacements at the origin of the relative position (substrate minus indenter) per uniform
/// traction on a rectangle, [m/Pa]: `xy` is u_x per traction in y. z points into the substrate,
/// tractions act on the substrate. Reciprocity: zx = -xz, zy = -yz at the same relative position.
struct InfluenceCoefficients {
    double xx, xy, yy, xz, yz, zx, zy, zz;
    double yx() const { return xy; }
};

/// Closed forms for half-spaces (Boussinesq 1885, Cerruti 1882; integrated by Love 1929), both
/// bodies' displacements added; Johnson (1985), eq. 3.19 and 3.75-3.76.
class RectangleInfluence {
  public:
    /// `width_x`, `width_y`: sides of the rectangle [m].
    RectangleInfluence(const contact::MaterialPair& materials, double width_x, double width_y);

    /// All coefficients at (x, y) [m] from the rectangle's centre.
    InfluenceCoefficients at(double x, double y) const;

  private:
    double half_x_, half_y_;
    double symmetric_, skew_, coupling_;  // (1-nu)/(2 pi G), nu/(2 pi G), (1-2nu)/(4 pi G) [1/Pa]
};

}  // namespace tricontact::bem

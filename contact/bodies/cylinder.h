#pragma once

#include "contact/bodies/indenter.h"

namespace tricontact::contact {

/// h = x^2 / (2 R) for |y| <= L/2, infinite beyond: what Hertz' theory calls a cylinder, its axis
/// along y.
class Cylinder final : public Indenter {
  public:
    /// R and L [m]. Throws InputError unless both are positive and finite.
    Cylinder(double radius, double length);
    double radius() const { return radius_; }
    double length() const { return length_; }
    double height(double x, double y) const override;
    Vector2 slope(double x, double y) const override;

  private:
    double radius_, length_;
};

}  // namespace tricontact::contact

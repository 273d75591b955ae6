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

/// A cylinder whose ends are rounded by a radius r:
/// h = x^2 / (2 R) + r - sqrt(r^2 - s^2) at the distance s from the straight part, which is L - 2 r
/// long; r = 0: sharp ends.
class Roller final : public Indenter {
  public:
    /// Lengths in m. Throws InputError unless 0 <= chamfer <= length / 2, and as Cylinder does.
    Roller(double radius, double length, double chamfer);

    double height(double x, double y) const override;
    /// Finite where the end's rounding is vertical: nothing touches there.
    Vector2 slope(double x, double y) const override;

  private:
    double rounded_distance(double y) const;  // s [m]; 0 on the straight part

    Cylinder cylinder_;
    double chamfer_;
};

}  // namespace tricontact::contact

#pragma once

#include "contact/indenter.h"

namespace tricontact::contact {

/// Cylinder of finite length along y, h = x^2 / (2 R), its ends rounded by a radius r:
/// h = x^2 / (2 R) + r - sqrt(r^2 - s^2) at the distance s from the straight part, which is L - 2 r
/// long; r = 0: sharp ends. Infinite beyond |y| = L/2.
class Roller final : public Indenter {
  public:
    /// Lengths in m. Throws InputError unless radius and length are positive and finite and
    /// 0 <= chamfer <= length / 2.
    Roller(double radius, double length, double chamfer);

    double height(double x, double y) const override;
    Vector2 slope(double x, double y) const override;

  private:
    double rounded_distance(double y) const;  // s [m]; 0 on the straight part

    double radius_, half_length_, chamfer_;
};

}  // namespace tricontact::contact

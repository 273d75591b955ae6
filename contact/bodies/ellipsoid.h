#pragma once

#include "contact/bodies/indenter.h"

namespace tricontact::contact {

/// h = x^2/(2 R_x) + y^2/(2 R_y): a body of two principal radii of curvature as Hertz takes it.
class Ellipsoid final : public Indenter {
  public:
    /// Radii [m] > 0 in the x-z and the y-z plane; InputError otherwise.
    Ellipsoid(double radius_x, double radius_y);
    double height(double x, double y) const override {
        return x * x / (2 * radius_x_) + y * y / (2 * radius_y_);
    }
    Vector2 slope(double x, double y) const override { return {x / radius_x_, y / radius_y_}; }
    bool presses_like_a_ball() const override { return false; }

  private:
    double radius_x_, radius_y_;
};

/// Hertz' contact of an ellipsoid with a half-space of the effective modulus E*.
struct EllipticContact {
    Vector2 semi_axes;     ///< a_x, a_y of the contact ellipse [m]
    double indentation;    ///< d [m]
    double normal_force;   ///< F_N over E* [m^2]
    double peak_pressure;  ///< p0 over E* [-]; p = p0 sqrt(1 - (x/a_x)^2 - (y/a_y)^2)
};

/// a_y/a_x > 0 of the contact ellipse, which every load leaves as it is: the root of
///   R_x/R_y = R_D(0, a_x^2, a_y^2)/R_D(0, a_y^2, a_x^2).
/// Johnson (1985), section 4.2, in Carlson's elliptic integrals, where no axis is the longer one.
double ellipse_ratio(double radius_x, double radius_y);

/// Contact of the half axis a_x [m] > 0: d = p0 a_x a_y R_F(0, a_x^2, a_y^2)/E*,
/// 1/R_x = 2/3 p0 a_x a_y R_D(0, a_y^2, a_x^2)/E*, F_N = 2/3 pi a_x a_y p0.
EllipticContact elliptic_contact(double radius_x, double ratio, double semi_axis_x);

}  // namespace tricontact::contact

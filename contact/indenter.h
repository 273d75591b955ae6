#pragma once

#include <vector>

#include "contact/vector2.h"

namespace tricontact::contact {

/// Undeformed shape of the indenter, lowest point at the origin, z out of the substrate.
/// Any height field fits: height maps and tilted bodies derive from this class.
class Indenter {
  public:
    virtual ~Indenter() = default;

    /// Height h(x, y) >= 0 of the surface over its lowest point [m]; infinity outside the body.
    virtual double height(double x, double y) const = 0;
    /// Gradient of the height [-]; only inside the body.
    virtual Vector2 slope(double x, double y) const = 0;
};

/// Body of revolution, profile h(r) with h(0) = 0.
class AxisymmetricIndenter : public Indenter {
  public:
    double height(double x, double y) const final;
    Vector2 slope(double x, double y) const final;

    /// h(r) [m] at radius r >= 0 [m].
    virtual double profile(double r) const = 0;
    /// dh/dr [-].
    virtual double profile_slope(double r) const = 0;
    /// Largest radius at which the profile is defined [m].
    virtual double outer_radius() const = 0;
    /// Radii in (0, outer radius) at which the slope jumps, increasing [m]; integrals over the
    /// profile are split there.
    virtual std::vector<double> kinks() const { return {}; }
};

/// h = r^2 / (2 R): what Hertz' theory calls a sphere.
class Paraboloid final : public AxisymmetricIndenter {
  public:
    explicit Paraboloid(double radius);
    double radius() const { return radius_; }
    double profile(double r) const override { return r * r / (2 * radius_); }
    double profile_slope(double r) const override { return r / radius_; }
    double outer_radius() const override;

  private:
    double radius_;
};

/// h = R - sqrt(R^2 - r^2), the exact lower half of a ball.
class Sphere final : public AxisymmetricIndenter {
  public:
    explicit Sphere(double radius);
    double radius() const { return radius_; }
    double profile(double r) const override;
    double profile_slope(double r) const override;
    double outer_radius() const override { return radius_; }

  private:
    double radius_;
};

}  // namespace tricontact::contact

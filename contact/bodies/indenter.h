#pragma once

#include <cmath>
#include <vector>

#include "contact/base/special_values.h"
#include "contact/base/vector2.h"

namespace tricontact::contact {

/// Undeformed shape of the indenter, z out of the substrate. The origin is its position, which for
/// all but measured bodies is its lowest point. Any height field fits: height maps and tilted
/// bodies derive from this class.
class Indenter {
  public:
    virtual ~Indenter() = default;

    /// Height h(x, y) >= 0 of the surface over its lowest point [m]; infinity outside the body.
    virtual double height(double x, double y) const = 0;
    /// Gradient of the height [-]; only inside the body.
    virtual Vector2 slope(double x, double y) const = 0;
    /// Its lowest point [m], roughness not counted: what it twists about unless told otherwise (see
    /// CentreOfRotation). The origin but for measured bodies.
    virtual Vector2 lowest_point() const { return {0, 0}; }
    /// Whether the pressure under it is about sqrt(1 - r^2/a^2) times a linear function of r^2, as
    /// under a ball: what moments of the pressure tell a by.
    virtual bool presses_like_a_ball() const { return true; }
};

/// Body of revolution, profile h(r) with h(0) = 0.
class AxisymmetricIndenter : public Indenter {
  public:
    double height(double x, double y) const final {
        const double r = std::hypot(x, y);
        return r <= outer_radius() ? profile(r) : infinity;
    }
    Vector2 slope(double x, double y) const final;

    /// h(r) [m] at radius r >= 0 [m].
    virtual double profile(double r) const = 0;
    /// dh/dr [-].
    virtual double profile_slope(double r) const = 0;
    /// Largest radius at which the profile is defined [m].
    virtual double outer_radius() const { return infinity; }
    /// Radii in (0, outer radius) at which the profile is not smooth, increasing [m]; integrals
    /// over the profile are split there.
    virtual std::vector<double> kinks() const { return {}; }

    // Frictionless contact of the radius x with a half-space of the effective modulus E*; Sneddon
    // (1965), Int. J. Eng. Sci. 3. `x`: 0 < x <= outer radius [m].

    // Unless the shape has a closed form the first two are computed by double exponential
    // quadrature between the kinks, r = x sin t taking away the singularity at r = x: 1e-12
    // relative, unless h' itself is ill-conditioned (near a vertical rim). The slope must not be
    // negative. They throw std::domain_error for another x and InputError where the estimated error
    // exceeds 1e-10: kinks that are not declared.

    /// ∫_0^x h'(r) r^k/sqrt(x^2 - r^2) dr [m^k] for k = 0 and 2.
    virtual double slope_moment(double x, int k) const;
    /// p(0)/E* [-], the pressure at the centre: 1/pi ∫_0^x g'/s ds, which is
    /// 1/pi ∫_0^x h'(r) [1/sqrt(x^2 - r^2) + acos(r/x)/r] dr with the order of integration changed;
    /// infinite under a conical tip.
    virtual double centre_pressure(double x) const;
    /// g(x) [m], x >= 0: the indentation d that the contact radius x belongs to, and the plane
    /// profile of the method of dimensionality reduction; Popov and Hess (2015), eq. 3.27.
    double plane_profile(double x) const { return x == 0 ? 0 : x * slope_moment(x, 0); }
    /// F_N/E* [m^2] at the contact radius x.
    double pressed_area(double x) const { return 2 * slope_moment(x, 2); }
};

/// h = r^2 / (2 R): what Hertz' theory calls a sphere.
class Paraboloid final : public AxisymmetricIndenter {
  public:
    explicit Paraboloid(double radius);
    double radius() const { return radius_; }
    double profile(double r) const override { return r * r / (2 * radius_); }
    double profile_slope(double r) const override { return r / radius_; }
    double slope_moment(double x, int k) const override {
        return (k == 0 ? x : 2. / 3 * x * x * x) / radius_;
    }

  private:
    double radius_;
};

/// h = R - sqrt(R^2 - r^2) = r^2 / (R + sqrt(R^2 - r^2)), the exact lower half of a ball.
class Sphere final : public AxisymmetricIndenter {
  public:
    explicit Sphere(double radius);
    double profile(double r) const override {
        return r * r / (radius_ + std::sqrt(radius_ * radius_ - r * r));
    }
    double profile_slope(double r) const override {
        return r / std::sqrt(radius_ * radius_ - r * r);
    }
    double outer_radius() const override { return radius_; }

  private:
    double radius_;
};

/// ∫_u^v r^k/sqrt(x^2 - r^2) dr [m^k], 0 <= u <= v <= x, k >= 0, by the recurrence
///   k M_k = (k - 1) x^2 M_(k-2) - [r^(k-1) sqrt(x^2 - r^2)]_u^v.
inline double arc_moment(double x, double u, double v, int k) {
    const double at_u = std::sqrt((x - u) * (x + u)), at_v = std::sqrt((x - v) * (x + v));
    if (k == 0) return std::atan2(v, at_v) - std::atan2(u, at_u);
    if (k == 1) return at_u - at_v;
    const double ends = std::pow(u, k - 1) * at_u - std::pow(v, k - 1) * at_v;
    return ((k - 1) * x * x * arc_moment(x, u, v, k - 2) + ends) / k;
}

}  // namespace tricontact::contact

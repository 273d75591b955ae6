#pragma once

#include "contact/bodies/indenter.h"

namespace tricontact::contact {

/// Flat cylindrical punch whose edge is rounded: h = 0 up to the flat radius b, (r - b)^2/(2 R)
/// beyond. Schubert (1942); Ciavarella (1999), J. Strain Anal. 34.
class RoundedPunch final : public AxisymmetricIndenter {
  public:
    /// `flat_radius` b, `radius` R > 0 [m]; InputError otherwise.
    RoundedPunch(double flat_radius, double radius);
    double flat_radius() const { return flat_radius_; }
    double radius() const { return radius_; }
    double profile(double r) const override;
    double profile_slope(double r) const override;
    double outer_radius() const override;
    std::vector<double> kinks() const override { return {flat_radius_}; }
    bool presses_like_a_ball() const override { return false; }
    /// g = x/R [sqrt(x^2 - b^2) - b acos(b/x)].
    double slope_moment(double x, int k) const override;

  private:
    double flat_radius_, radius_;
};

}  // namespace tricontact::contact

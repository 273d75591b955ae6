#pragma once

#include <memory>
#include <span>

#include "contact/bodies/indenter.h"

namespace tricontact::mdr {

/// Even plane profile g(x) >= 0, not decreasing with |x|, g(0) = 0: what springs are pressed with.
/// Lengths in m.
class PlaneProfile {
  public:
    virtual ~PlaneProfile() = default;

    /// g(x) [m]; infinity for |x| > `range`.
    virtual double value(double x) const = 0;
    /// heights[i] = g(first + i spacing): the springs of a bed at once.
    virtual void sample(double first, double spacing, std::span<double> heights) const = 0;
    /// Largest |x| at which g is known [m].
    virtual double range() const = 0;
    /// ∫_0^a g dx [m^2], 0 <= a <= range.
    virtual double integral(double a) const = 0;
    /// ∫_0^a g'(x)/x dx [-]: the pressure at the centre of the contact is E*/pi times this.
    /// Infinite for a conical tip.
    virtual double centre_integral(double a) const = 0;

    /// Half width a [m] of the contact at the depth d [m] > 0: g(a) = d.
    /// Throws contact::InputError if d exceeds g(range).
    double half_width(double depth) const;
    /// Half width a [m] at which 2 ∫_0^a (g(a) - g(x)) dx = area [m^2], F_N/E* in contact.
    /// Throws contact::InputError if the range does not suffice.
    double half_width_of_area(double area) const;
};

/// g = factor |x|^n of a power-law indenter h = c r^n.
class PowerLawProfile final : public PlaneProfile {
  public:
    /// `coefficient` c > 0 [m^(1-n)], `exponent` n >= 1; std::domain_error otherwise.
    PowerLawProfile(double coefficient, double exponent);

    double value(double x) const override;
    void sample(double first, double spacing, std::span<double> heights) const override;
    double range() const override;
    double integral(double a) const override;
    double centre_integral(double a) const override;

  private:
    double factor_, exponent_;
};

/// The closed form where the indenter has one (paraboloid, power law), else a table over |x| <=
/// range [m], cut off just inside the indenter's outer radius.
std::unique_ptr<PlaneProfile> make_plane_profile(const contact::AxisymmetricIndenter& indenter,
                                                 double range);

}  // namespace tricontact::mdr

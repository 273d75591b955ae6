#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "contact/base/special_values.h"
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
    virtual double range() const { return contact::infinity; }
    /// ∫_0^a g dx [m^2], 0 <= a <= range.
    virtual double integral(double a) const = 0;
    /// ∫_0^a g'(x)/x dx [-]: the pressure at the centre of the contact is E*/pi times this.
    /// Infinite for a conical tip.
    virtual double centre_integral(double a) const = 0;
    /// g'(0) [-], 0 unless the tip is conical; `a` [m] is any half width.
    double tip_slope(double a) const;

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

    double value(double x) const override {
        return exponent_ == 2 ? factor_ * x * x : factor_ * std::pow(std::abs(x), exponent_);
    }
    void sample(double first, double spacing, std::span<double> heights) const override;
    double integral(double a) const override { return a * value(a) / (exponent_ + 1); }
    double centre_integral(double a) const override {
        if (exponent_ <= 1) return contact::infinity;
        return exponent_ / (exponent_ - 1) * value(a) / a;
    }

  private:
    double factor_, exponent_;
};

/// The closed form where the indenter has one (paraboloid, power law), else a table over |x| <=
/// range [m], cut off just inside the indenter's outer radius.
std::unique_ptr<PlaneProfile> make_plane_profile(const contact::AxisymmetricIndenter& indenter,
                                                 double range);

/// The profile g of any indenter, transformed once and kept as piecewise Chebyshev series of the
/// mean slope g(x)/x, on panels between the kinks, bisected until the series has converged to 1e-12
/// of its largest value. A spring then costs one short sum and not a quadrature.
class TabulatedProfile final : public PlaneProfile {
  public:
    /// Table for |x| <= range [m], 0 < range <= outer radius (less if the slope is infinite there).
    /// Throws std::domain_error for another range, contact::InputError for a profile whose g
    /// decreases somewhere (the contact would not be a disc) or that is too rough.
    TabulatedProfile(const contact::AxisymmetricIndenter& indenter, double range);

    double value(double x) const override;
    void sample(double first, double spacing, std::span<double> heights) const override;
    double range() const override { return range_; }
    double integral(double a) const override;
    double centre_integral(double a) const override;

  private:
    static constexpr int n_terms = 16;
    struct Panel {
        double begin, end;
        std::array<double, n_terms> coefficients;  // of T_0, T_1, ...; T_0 in full

        double mean_slope(double x) const;
    };

    static Panel fit(const contact::AxisymmetricIndenter& indenter, double begin, double end);
    void tabulate(const contact::AxisymmetricIndenter& indenter, double begin, double end);
    void check_monotone() const;
    const Panel& panel_at(double distance) const;

    double range_;
    bool conical_;              // h'(0) > 0
    double largest_slope_ = 0;  // of g(x)/x
    std::vector<Panel> panels_;
};

}  // namespace tricontact::mdr

#pragma once

#include <array>
#include <vector>

#include "mdr/plane_profile.h"

namespace tricontact::mdr {

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

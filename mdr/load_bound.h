#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/friction/radial_bound.h"
#include "mdr/line_surface.h"

namespace tricontact::mdr {

/// What a line carries along the surface under any law of friction, from its normal loads q(x)
/// alone: q is the integral of a pressure p(r) across the load, so that
///   p(r) = -1/pi ∫_r^a q'(x)/sqrt(x^2 - r^2) dx,  b(x) = 2 ∫_x^a tau(p(r)) r dr/sqrt(r^2 - x^2).
/// The middle of the loaded points is the axis. What a layer couples needs no more: its p is that
/// of its own q.
///
/// A relaxing substrate that rolls leans its load forward, and no p(r) has it. There each chord has
/// the pressure of the even part of q times what it carries over that part:
///   b(x) = 2 ∫_x^a tau(s p(r)) r dr/sqrt(r^2 - x^2),  s = q(x)/[(q(x) + q(-x))/2],
/// which is mu q of Coulomb's law, 2 tau_0 sqrt(a^2 - x^2) of a shear strength, and the above of an
/// even load.
class LoadBound {
  public:
    /// `may_lean`: loads need not be even. `tip_slope`: -q'(0) [N/m^2] beside a conical tip, under
    /// which p is infinite; else, and if unknown, 0.
    LoadBound(std::shared_ptr<const contact::FrictionLaw> law, bool may_lean, double tip_slope = 0);

    /// bound[i] [N/m] where load[i] [N/m] is positive, else 0.
    void bounds(const PointRow& row, std::span<const double> load, std::span<double> bound) const;

  private:
    std::vector<double> even_bound(std::span<const double> pressure) const;
    std::vector<double> lean_factors(std::span<const double> pressure,
                                     std::span<const double> even_bound,
                                     std::span<const double> share) const;

    std::shared_ptr<const contact::FrictionLaw> law_;
    bool may_lean_;
    double tip_slope_;
    std::shared_ptr<const contact::RadialBound> radial_;
};

}  // namespace tricontact::mdr

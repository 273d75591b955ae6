#pragma once

#include <optional>
#include <vector>

#include "contact/case.h"
#include "theory/hertz_under_law.h"

namespace tricontact::theory {

/// What body_rolling.h says of Coulomb's law, for any law by which a point carries tau(p) and a
/// body of revolution whose pressure falls with r: its springs carry
///   b(x) = 2 ∫_x^a tau r dr/sqrt(r^2 - x^2), which is also ∫ tau dy across the load at x,
/// and the limit F_lim = 2 ∫_0^a b dx. With f = F_T/F_lim, w = W/a and u = U G*/b(0), all in [0,
/// 1]:
///   shift of a force applied once  f = 2/F_lim ∫_0^a min(u b(0), b(x)) dx,
///   after oscillating rolling      f = 2/F_lim ∫_W^a min(u b(0), b(x)) dx,
/// the latter of the bed of springs; its limit 2/F_lim ∫_W^a b dx is exact in three dimensions too,
/// where the least bounds of the path are those at its ends. What sticks within x >= W loses 2 W u
/// of the static force, so that u of a settled contact is b at the edge x. Of a shear strength
/// tau_0 alone
///   f = (2/pi) [u sqrt(1 - u^2) + arcsin u - 2 w u],  f_lim = (2/pi) [arccos w - w sqrt(1 - w^2)].
class BedUnderLaw {
  public:
    /// Throws contact::InputError for a body that is none of revolution.
    explicit BedUnderLaw(const contact::Case& c);

    double static_shift_ratio(double f) const { return *settled_shift_ratio(0, f); }
    double shakedown_limit(double w) const;
    double amplitude_limit(double f) const;
    /// Empty above the limit.
    std::optional<double> settled_shift_ratio(double w, double f) const;
    /// F_lim [N] on the half-space.
    double friction_limit() const { return friction_limit_; }

  private:
    // At the edge of stick x = cos(angle), over b(0) and a.
    double bound(double angle) const;
    double static_force(double angle) const;  // 2 [x b + ∫_x^1 b]
    double beyond(double angle) const;        // ∫_x^1 b, of a table
    double rolled_force(double w, double angle) const;

    std::optional<HertzUnderLaw> round_;  // closed forms; else tables
    std::vector<double> bound_;   // over b(0), at equal distances of sqrt(1 - x^2), edge first
    std::vector<double> beyond_;  // at equal distances of the angle
    double whole_ = 0;            // static_force of the middle
    double friction_limit_ = 0;
};

}  // namespace tricontact::theory

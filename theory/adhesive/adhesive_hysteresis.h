#pragma once

#include <optional>
#include <utility>

#include "theory/adhesive/adhesive_curve.h"

namespace tricontact::theory {

/// Short-ranged adhesion whose work of approach w_a is less than that of separation w, so that a
/// loop costs energy without a jump: the edge of the contact advances where less than w_a closes
/// it, recedes where w opens it, and stays where it is in between, its energy release rate being
///   w_a <= (E* e l)^2/(2 pi a E*) <= w.
/// There the contact is that of a punch of the radius a: F and d are linear in l. See
/// AdhesiveCurve, which is either branch. w_a = w: no branch but one.
class AdhesiveHysteresis {
  public:
    using State = AdhesiveCurve::State;
    using Motion = AdhesiveCurve::Motion;

    /// `approach_work` in [0, work] [J/m^2]; all else, and what is thrown, as AdhesiveCurve's.
    AdhesiveHysteresis(const AdhesiveCurve::Family& family, double modulus, double work,
                       double approach_work, double guess, double largest_radius);

    /// One work of adhesion.
    explicit AdhesiveHysteresis(AdhesiveCurve reversible)
        : separation_(std::move(reversible)), approach_work_(separation_.work_of_adhesion()) {}

    bool is_reversible() const { return !approach_; }
    /// From a state to that under a control, slowly; `released` is what is lost in jumps and where
    /// the edge recedes, w - w_a per area [J].
    Motion follow(const State& from, const contact::NormalControl& control);
    bool reaches(const contact::NormalControl& control);
    /// See AdhesiveCurve, of one work.
    int stable_states(const contact::NormalControl& control) {
        return separation_.stable_states(control);
    }
    /// Of a contact that has been as wide as this and not wider [m]: a narrow one lets go at once
    /// where a wider one would shrink before.
    contact::PullOff pull_off(double widest);

    /// U - w_a A [J], what the work of the force changes where nothing is lost.
    double stored(const State& s) const;
    double work_of_separation() const { return separation_.work_of_adhesion(); }

  private:
    AdhesiveCurve separation_;
    std::optional<AdhesiveCurve> approach_;  // empty: the same
    double approach_work_;                   // [J/m^2]
};

}  // namespace tricontact::theory

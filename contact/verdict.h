#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::contact {

/// What one period of rolling shows of the contact's fate.
struct RolledPeriod {
    double increment = 0;           ///< of the shift, over U_max
    double work = 0;                ///< frictional, see Judge, over mu F_N U_max
    bool something_sticks = false;  ///< a point was in contact and stuck in all steps
};

/// The shift comes to stand, whatever slips back and forth.
inline bool settles(State state) {
    return state == State::shakedown || state == State::cyclic_slip;
}

/// A shift is known to this part of U_max: a tenth of the 0.1 % that discretisations leave and
/// models differ by.
inline constexpr double known_shift = 1e-4;

/// What is known of a contact before it rolls.
struct Judged {
    /// A period that shifts the contact by less, over U_max, does not shift it, and one that works
    /// less, over mu F_N U_max, does no work. A point that slips by ten accuracies of U_max in a
    /// step counts as sticking (SurfaceModel), so that ten of them times mu F_N are work of the
    /// solver; never less than what ends a run (has_settled).
    double negligible_shift = 1e-7, negligible_work = 1e-6;
    bool has_load = true;  ///< F_T is not 0
    /// Periods until a relaxing substrate has forgotten the first; what it does before is creep.
    double memory = 0;
    /// f_T where the limit of uncoupled contact decides, see Judge; and the accuracy of the limit.
    std::optional<double> tangential_ratio{};
    double limit_accuracy = 0;
};

/// Neither F_N or d nor F_T oscillates with the rolling.
bool has_constant_loads(const Case& c);

/// Of a case on a model whose scales and amplitude are known; `accuracy`: Model::step_accuracy().
Judged judged(const Case& c, double accuracy, bool coupled, double amplitude,
              double tangential_ratio);

/// The fate of a contact that rolls back and forth, told period by period: what becomes of the
/// shifts U and of the frictional works. What was decided once stays decided.
///
/// By the limit: where normal and tangential contact are uncoupled, the bodies elastic and F_T
/// constant, the contact shakes down if f_T = F_T/(mu F_N) is below
/// f_T,lim = (1/F_N) ∫ min p dA, the least pressures of the (discrete) path, and ratchets above it,
/// whatever the first periods look like (Melan's theorem for frictional contact: Klarbring,
/// Ciavarella and Barber, Int. J. Solids Struct. 44 (2007) 8355-8365; that nothing but shakedown is
/// left without a net shift follows from the work of F_T, which is then zero). F_N may oscillate.
/// One period tells f_T,lim; within its accuracy of it, the series decides.
///
/// By the series otherwise:
/// - Shakedown: shift and work are negligible in a period. Under constant loads the work is that of
///   points in contact throughout the period: one that comes into contact during a finite step is
///   held to where it was at the step's start, and in coupled contact slips back and forth at the
///   rim in each period, by an amount that vanishes with the steps. What a force that oscillates
///   does at the rim (Mindlin and Deresiewicz 1953) does not vanish: then all work counts.
/// - Cyclic slip: for the last quarter of the periods, four at least, the shift has been
///   negligible, but the work has not, and has stayed within 1 % of its value.
/// - Ratcheting: in none of the last quarter, five at least, has a point stuck throughout the
///   period, and the increments decline so slowly, or not at all, that the contact would have to
///   shift by more than twice U_max until it rests.
/// A point that never slips moves as its traction, which is bounded: it holds the indenter back.
/// Under F_T none may be left in a contact that ratchets, and one must be in a contact that does
/// not, however small the increments. Just beyond the limit the shift passes a narrow place, where
/// increments sink to the order of the distance from the limit and rise again: that takes of the
/// order of its power -1/2 in periods.
class Judge {
  public:
    explicit Judge(const Judged& judged) : judged_(judged) {}

    void add(const RolledPeriod& period) {
        periods_.push_back(period);
        if (state_ == State::undecided) state_ = decide();
    }
    /// Limit of the discrete path; from the first period on.
    void set_limit(double limit_tangential_ratio) {
        if (!judged_.tangential_ratio || by_limit_) return;
        const double excess = *judged_.tangential_ratio - limit_tangential_ratio;
        by_limit_ = std::abs(excess) > judged_.limit_accuracy;
        if (by_limit_) state_ = excess > 0 ? State::ratcheting : State::shakedown;
    }

    State state() const { return state_; }
    /// The limit leaves the fate to the series, or does not hold.
    bool needs_series() const { return !by_limit_; }
    /// Nothing happens any more, which ends a run: in the last period the shift moved by at most
    /// 1e-7 U_max and friction worked at most 1e-6 mu F_N U_max.
    bool has_settled() const;
    /// With what is still to come and what is missing.
    Verdict verdict() const;
    /// Decided, and what is still to come is known, to `known_shift`; or, of ratcheting, the
    /// increment to 1 %.
    bool is_known() const;

  private:
    bool has_forgotten() const { return static_cast<double>(periods_.size()) >= judged_.memory; }
    bool has_hold(const RolledPeriod& period) const {
        return period.something_sticks || !judged_.has_load;
    }
    bool stands(const RolledPeriod& period) const {
        return std::abs(period.increment) <= judged_.negligible_shift && has_hold(period);
    }
    bool repeats_its_work() const;
    bool ratchets() const;
    State decide() const;
    std::string missing() const;

    Judged judged_;
    std::vector<RolledPeriod> periods_;
    State state_ = State::undecided;
    bool by_limit_ = false;
};

/// A value with a bound on its error.
struct Bounded {
    double value = 0, error = 0;
};

/// What a decaying series x_1 ... x_n still adds: its time constant and how it grows, from three
/// values a sixth of the series apart, continue it. That is exact for q^n and, as n grows, for n^-p
/// (between both lies what settles just below the limit). The bound adds up what a growth twice as
/// large (up to half way to divergence) or none would change, how far the last quarter of the
/// series would have said otherwise, a tenth, and `noise`, below which values tell nothing.
/// Infinite error for fewer than five values and while they do not decay.
Bounded still_to_come(std::span<const double> series, double noise);

/// What an interval of an increment tells, positive in the direction of the load: ratcheting if all
/// of it is above 0, shakedown if it adds less than `negligible`; else undecided.
State state_of(double low, double high, double negligible);

}  // namespace tricontact::contact

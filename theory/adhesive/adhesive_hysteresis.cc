#include "theory/adhesive/adhesive_hysteresis.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace tricontact::theory {

using contact::NormalControl;
using std::numbers::pi;

namespace {

/// An approach that gains nothing: l is 1e-7 of that of separation.
constexpr double least_share = 1e-14;

double area_of(const AdhesiveCurve::State& s) {
    return pi * s.radius * s.radius;
}

}  // namespace

AdhesiveHysteresis::AdhesiveHysteresis(const AdhesiveCurve::Family& family, double modulus,
                                       double work, double approach_work, double guess,
                                       double largest_radius)
    : separation_(family, modulus, work, guess, largest_radius),
      approach_work_(std::max(approach_work, least_share * work)) {
    if (!(approach_work >= 0) || !(approach_work <= work))
        throw std::domain_error("AdhesiveHysteresis: the work of approach must lie in [0, w]");
    if (approach_work < work)
        approach_.emplace(family, modulus, approach_work_, guess, largest_radius);
}

double AdhesiveHysteresis::stored(const State& s) const {
    return approach_ ? s.energy - approach_work_ * area_of(s) : AdhesiveCurve::stored(s);
}

AdhesiveHysteresis::Motion AdhesiveHysteresis::follow(const State& from,
                                                      const NormalControl& control) {
    if (!approach_) return separation_.follow(from, control);
    if (!from.touches()) return approach_->follow(from, control);
    const double now = control.kind == NormalControl::Kind::force ? from.force : from.indentation;
    if (now == control.value) return {.state = from};
    const bool presses = control.value > now;
    AdhesiveCurve& moving = presses ? *approach_ : separation_;
    const State held = separation_.held(from.radius, control), end = moving.at(from.radius);
    const bool stays = presses ? held.detached >= end.detached : held.detached <= end.detached;
    const State& to = stays ? held : end;
    const double pinned_work = (from.force + to.force) / 2 * (to.indentation - from.indentation);
    if (stays) return {.state = held, .work = pinned_work};
    Motion motion = moving.follow(end, control);
    motion.work += pinned_work;
    if (!presses)
        motion.released += (separation_.work_of_adhesion() - approach_work_) *
                           (area_of(end) - area_of(motion.state));
    return motion;
}

bool AdhesiveHysteresis::reaches(const NormalControl& control) {
    return separation_.reaches(control) && (!approach_ || approach_->reaches(control));
}

contact::PullOff AdhesiveHysteresis::pull_off(double widest) {
    contact::PullOff off = separation_.pull_off();
    if (!approach_) return off;
    // Beyond its least value either control rises with the radius.
    constexpr double beside = 1 - 1e-5;
    const State last = separation_.at(widest), narrower = separation_.at(beside * widest);
    if (last.force < narrower.force) {
        off.force = -last.force;
        off.radius = widest;
        off.indentation = last.indentation;
    }
    if (last.indentation < narrower.indentation) off.last_indentation = last.indentation;
    return off;
}

}  // namespace tricontact::theory

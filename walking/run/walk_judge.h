#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "walking/machine/machine.h"
#include "walking/run/walk.h"

namespace tricontact::walking {

/// Sums over windows or returns, one after another.
template <class Stretch>
StretchSums total(std::span<const Stretch> stretches) {
    StretchSums sums;
    for (const Stretch& each : stretches) sums.add(each.sums);
    return sums;
}

/// Mean spring force of a window, in units of k_x b.
double mean_force(const WalkWindow& window);

/// Whether no spot slips or leaves the ground in any of these windows: the spring is being loaded,
/// or it is at rest.
bool only_sticks(std::span<const WalkWindow> windows);

/// First window of those that are left when the spring is loaded: its mean force lies within the
/// range of the windows after it. While a force rises, or falls, it is outside of that. The number
/// of the windows if there is none.
std::size_t first_loaded(const Machine& machine, std::span<const WalkWindow> windows);

/// Error of the mean spring force, in units of k_x b; at least one window. Where all spots slip,
/// swings go on undamped: the range of the force's integral about its mean, over the time. Where a
/// spot sticks, and in the prism, a mean may still approach its end: then not less than the way
/// from it to that of the last third, and on by twice what that differs from the third before,
/// which is all that is to come if each third comes nearer by a third or more; nor more than what
/// sticking takes from the force of sliding, as swings that do not grow let no more stick.
double mean_error(const Machine& machine, std::span<const WalkWindow> windows);

/// Whether the mean spring force has no trend: the last third of the windows, and of their second
/// half, has that of the first third, but for swings: those of their windows, and what the momentum
/// of the body can make of the difference. False for fewer than six windows.
bool is_evenly_pulled(const Machine& machine, std::span<const WalkWindow> windows);

/// Whether the spots slide as far as the base moves but for swings; at least one window. What they
/// do not, the spring takes up. Each comes as far ahead of the base or behind as the spring, the
/// spot and the rotation give way, swings of which leave both ends of the way off by what lies
/// between them: twice the greatest deviation from an even way. The way has to be as long as the
/// base's within this, and longer than this, or nothing tells sliding from swinging on the spot. A
/// lag that loads the spring by less than is told of a mean does not count. True for a base that
/// rests.
bool moves_with_base(const Machine& machine, std::span<const WalkWindow> windows);

/// Time in which the base loads the spring to the force of sliding, the spots sticking and the body
/// not turning, so that it takes no less; infinite for a base that rests.
double loading_time(const Machine& machine);

/// How often a motion like that of these windows is to be expected to pass tilting_limit in a time
/// `times` as long: from the tail of the windows' greatest |phi|, which above their median is taken
/// to fall off exponentially; that of a bounded or of a normally distributed motion falls faster.
/// Infinite where |phi| rises from window to window and would be there at this rate.
double expected_falls(const Machine& machine, std::span<const WalkWindow> windows, double times);

/// Whether a machine whose base stands still (kappa6 = 0) has come to rest under its excitation:
/// sets drift and regime of the result of a run that did not tilt. Empty for fewer than eight
/// periods, which do not tell.
void judge_drift(const Machine& machine, const std::vector<ExcitedPeriod>& periods,
                 WalkResult& result);

/// Amplitudes of the moment over kappa4, or of the force, at which a two-spot machine changes its
/// ways if it is excited slowly and pulled by f = <f_s>/(mu kappa4) in [0, 1].
struct DriftLimits {
    double ratcheting = 0;  ///< above it does not shake down
    double lift_off = 0;    ///< above its trailing spot leaves the ground
};

/// Loads of the spots, quasi-static: (1 ± f mu/mu_c ± m sin)/2 of the weight under a moment, with
/// mu_c of critical_friction; (1 - m sin)/2 each under a force. What the spots carry at their least
/// load, they carry always: the machine shakes down below f = 1 - m, as MDR's bed does at its
/// least loads (Wetter (2016), section 3.2). Rolling of the tips, W = R Phi, moves the limits by
/// less than the contact's radius over b.
DriftLimits drift_limits(const Machine& machine, double pull);

/// What is known of a run, however it was computed.
struct WalkEvidence {
    double step = 0;                         ///< of the integration
    std::span<const WalkWindow> windows;     ///< of equal length, the whole run
    std::span<const SectionReturn> returns;  ///< of its end, for judged_time if it is that long
    std::optional<double> tilting_time;      ///< where it was stopped, if it tilted
};

/// Time at the end of a run in which the judge looks for a limit cycle: some 45 returns of set B.
inline constexpr double judged_time = 200;

/// Length of the windows, as a number of steps: 200 in a run, none shorter than five swings.
std::int64_t window_steps(std::int64_t n_steps, double step);

/// Whether a run may have ended on a limit cycle: it vibrates, and the extremes of its end, in
/// which limit cycles are looked for, are the same in both halves. Without that it has no use for
/// returns.
bool may_repeat(const Machine& machine, std::span<const WalkWindow> windows);

/// Fills in whatever is but a mean or an extreme over the steps of a stretch.
void take_statistics(const Machine& machine, const StretchSums& sums, WalkResult& result);

/// Regime and statistics of a run of at least one window.
WalkResult judge(const Machine& machine, const WalkEvidence& evidence);

}  // namespace tricontact::walking

#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "walking/machine/machine.h"
#include "walking/machine/walk_record.h"

namespace tricontact::walking {

/// What is known of a run, however it was computed.
struct WalkEvidence {
    double step = 0;                         ///< of the integration
    std::span<const WalkWindow> windows;     ///< of equal length, the whole run
    std::span<const SectionReturn> returns;  ///< of its end, for judged_time() if it is that long
    std::optional<double> tilting_time;      ///< where it was stopped, if it tilted
};

/// Time at the end of a run in which the judge looks for a limit cycle: some 45 returns of set B.
double judged_time();

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

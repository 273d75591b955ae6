#include "walking/run/drift.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tricontact::walking {

PeriodRecorder::PeriodRecorder(const Machine& machine, const Motion& start)
    : start_(start.time), length_(2 * std::numbers::pi / machine.excitation.frequency) {}

void PeriodRecorder::add(const Motion& motion) {
    ++steps_;
    const auto in_the_air = [](const SpotDeflection& spot) { return spot.normal == 0; };
    if (std::any_of(motion.spots.begin(), motion.spots.end(), in_the_air)) ++airborne_;
    if (motion.time - start_ < static_cast<double>(periods_.size() + 1) * length_) return;
    periods_.push_back({motion.x + motion.phi, static_cast<double>(airborne_) / steps_});
    steps_ = airborne_ = 0;
}

void judge_drift(const Machine& machine, const std::vector<ExcitedPeriod>& periods,
                 WalkResult& result) {
    constexpr std::size_t fewest = 8;
    if (result.regime == Regime::tilting || periods.size() < fewest) return;
    // The second half: shakedown takes its time.
    const std::size_t first = periods.size() / 2 - 1, last = periods.size() - 1;
    const double n = static_cast<double>(last - first);
    const double per_period = (periods[last].shift - periods[first].shift) / n;
    double deviation = 0, airborne = 0;
    for (std::size_t i = first; i <= last; ++i) {
        const double even = periods[first].shift + static_cast<double>(i - first) * per_period;
        deviation = std::max(deviation, std::abs(periods[i].shift - even));
        if (i > first) airborne += periods[i].airborne / n;
    }
    const double unit =
        machine.kappas.kappa5 * machine.kappas.kappa2 * static_displacement(machine);  // U_max
    // Vibrations are not damped: both ends may be off by what lies between them. A shift that
    // comes to rest, if only by a factor of e in this time, bends away by an eighth of itself.
    WalkResult::Drift drift{per_period / unit, 2 * deviation / n / unit, airborne};
    const bool moves = std::abs(drift.per_period) > 4 * drift.error;
    constexpr double settled = 0.01;  // of U_max in a period
    result.regime = airborne > 0 ? Regime::walking : moves ? Regime::ratcheting : Regime::shakedown;
    result.transient_over = moves || drift.error < settled;
    result.drift = drift;
}

DriftLimits drift_limits(const Machine& machine, double pull) {
    const double tilt = machine.excitation.moment > 0
                            ? pull * machine.kappas.kappa5 / critical_friction(machine.kappas)
                            : 0;
    return {1 - pull, 1 - std::abs(tilt)};
}

}  // namespace tricontact::walking

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/base/special_values.h"
#include "statistics/stationarity.h"
#include "walking/machine/motion.h"
#include "walking/run/walk_judge.h"

namespace tricontact::walking {

namespace {

// Over the force of sliding: rounding of the integration, and what is told of a mean at most.
constexpr double rounding = 1e-9, resolution = 1e-7;

double duration(const WalkWindow& window) {
    return window.end - window.begin;
}

struct MeanForce {
    double force, time;
};

MeanForce mean_of(std::span<const WalkWindow> windows) {
    double impulse = 0, time = 0;
    for (const WalkWindow& window : windows) {
        impulse += mean_force(window) * duration(window);
        time += duration(window);
    }
    return {impulse / time, time};
}

/// Greatest change of the momentum that friction and the weight do not account for, |x'| and
/// mu |z'| at both ends: a velocity is at most twice the root of its mean square in a swing of two
/// frequencies.
double momentum_bound(const Machine& machine, std::span<const WalkWindow> windows) {
    const StretchSums sums = total(windows);
    const double base = machine.kappas.kappa6;
    const double mean_square =
        std::max(2 * sums.kinetic_energy / static_cast<double>(sums.steps) - base * base, 0.);
    return 2 * 2 * std::hypot(1, machine.kappas.kappa5) * std::sqrt(mean_square);
}

/// Range of the integral of the force about its mean, over the time.
double swing_error(std::span<const WalkWindow> windows) {
    // A window's own deviation would not do: about a period long, it averages over the swing, and
    // what is left adds up over many.
    const MeanForce mean = mean_of(windows);
    double integral = 0, least = 0, greatest = 0;
    for (const WalkWindow& window : windows) {
        integral += (mean_force(window) - mean.force) * duration(window);
        least = std::min(least, integral);
        greatest = std::max(greatest, integral);
    }
    return (greatest - least) / mean.time;
}

/// What sticking takes from the force of sliding. The spots carry the weight together, and those
/// that slip do so with friction mu times their part of it: all that is missing of the force of
/// sliding is missing where a spot sticks. In the prism slip turns on the flanks, and in a bed
/// springs stick while others slip, so that this does not tell.
double lost_to_sticking(const Machine& machine, double mean) {
    return machine.model == Machine::Model::prism || machine.bed
               ? contact::infinity
               : std::abs(sliding_force(machine) - mean);
}

/// Whether first and last third have the same mean force but for swings: those of their windows,
/// and what the momentum of the body can make of the difference.
bool thirds_agree(const Machine& machine, std::span<const WalkWindow> windows) {
    const statistics::Thirds<WalkWindow> thirds(windows);
    if (thirds.first.empty()) return false;
    const MeanForce first = mean_of(thirds.first), last = mean_of(thirds.last);
    const double swings = swing_error(thirds.first) + swing_error(thirds.last) +
                          momentum_bound(machine, thirds.first) / first.time +
                          momentum_bound(machine, thirds.last) / last.time;
    return std::abs(last.force - first.force) <= swings + rounding * sliding_force(machine);
}

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

/// Where the mean of the values is after so many times their number more, if it goes on as from
/// their first to their last third.
double continued(std::span<const double> values, double times) {
    const statistics::Thirds<double> thirds(values);
    const double last = mean_of(thirds.last), first = mean_of(thirds.first);
    const double thirds_apart = static_cast<double>(values.size() - thirds.last.size()) /
                                static_cast<double>(values.size());
    return last + times * (last - first) / thirds_apart;
}

}  // namespace

double mean_force(const WalkWindow& window) {
    return window.sums.spring_force / static_cast<double>(window.sums.steps);
}

bool only_sticks(std::span<const WalkWindow> windows) {
    return std::ranges::all_of(windows, [](const WalkWindow& window) {
        return std::ranges::all_of(window.sums.spots, [&](const SpotSums& spot) {
            return spot.sticking == window.sums.steps;
        });
    });
}

std::size_t first_loaded(const Machine& machine, std::span<const WalkWindow> windows) {
    const double slack = rounding * sliding_force(machine);
    double least = contact::infinity, greatest = -least;
    std::size_t first = windows.size();
    for (std::size_t i = windows.size(); i-- > 0;) {
        const double force = mean_force(windows[i]);
        if (force >= least - slack && force <= greatest + slack) first = i;
        least = std::min(least, force);
        greatest = std::max(greatest, force);
    }
    return first;
}

double mean_error(const Machine& machine, std::span<const WalkWindow> windows) {
    const double swings = std::max(swing_error(windows), resolution * sliding_force(machine));
    const statistics::Thirds<WalkWindow> thirds(windows);
    if (thirds.last.empty()) return swings;
    const double mean = mean_of(windows).force, end = mean_of(thirds.last).force,
                 before = mean_of(thirds.second).force;
    const double to_come = std::abs(end - mean) + 2 * std::abs(end - before);
    return std::max(swings, std::min(to_come, lost_to_sticking(machine, mean)));
}

bool is_evenly_pulled(const Machine& machine, std::span<const WalkWindow> windows) {
    const std::size_t half = windows.size() / 2;
    return thirds_agree(machine, windows) && thirds_agree(machine, windows.subspan(half));
}

bool moves_with_base(const Machine& machine, std::span<const WalkWindow> windows) {
    if (!(machine.kappas.kappa6 > 0)) return true;
    const double time = mean_of(windows).time;
    const double least = std::max(rounding, resolution * loading_time(machine) / time);
    for (std::size_t spot = 0; spot < windows.front().sums.spots.size(); ++spot) {
        // Of the spot's velocity over that of the base, less 1.
        const auto lead = [&](const WalkWindow& window) {
            const double velocity =
                window.sums.spots[spot].velocity / static_cast<double>(window.sums.steps);
            return (velocity / machine.kappas.kappa6 - 1) * duration(window) / time;
        };
        double all = 0, passed = 0, sum = 0, deviation = 0;
        for (const WalkWindow& window : windows) all += lead(window);
        for (const WalkWindow& window : windows) {
            passed += duration(window) / time;
            sum += lead(window);
            deviation = std::max(deviation, std::abs(sum - passed * all));
        }
        const double error = 2 * deviation;
        if (std::abs(all) > error + least || 1 + all <= error) return false;
    }
    return true;
}

double loading_time(const Machine& machine) {
    double stiffness = 0;
    for (const Spot& spot : spots_of(machine))
        stiffness += spot_force(machine, spot, {.tangential = 1}).tangential;
    const double way = sliding_force(machine) * (1 / machine.kappas.kappa1 + 1 / stiffness);
    return way / machine.kappas.kappa6;
}

double expected_falls(const Machine& machine, std::span<const WalkWindow> windows, double times) {
    std::vector<double> rotations;
    for (const WalkWindow& window : windows)
        rotations.push_back(std::max(-window.sums.phi_min, window.sums.phi_max) /
                            tilting_limit(machine));
    if (rotations.size() < 6) return 0;
    if (!statistics::stationary(rotations) && continued(rotations, times) >= 1)
        return contact::infinity;
    std::ranges::sort(rotations);
    const auto tail = std::span(rotations).subspan(rotations.size() / 2);
    const double median = tail.front(), excess = mean_of(tail) - median;
    if (!(excess > 0)) return 0;
    return times * static_cast<double>(tail.size()) * std::exp(-(1 - median) / excess);
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

#include "dynamics/drive_load.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/forces.h"

namespace tricontact::dynamics {
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
    double energy = 0, steps = 0;
    for (const WalkWindow& window : windows) {
        energy += window.sums.kinetic_energy;
        steps += static_cast<double>(window.sums.steps);
    }
    const double base = machine.kappas.kappa6;
    const double mean_square = std::max(2 * energy / steps - base * base, 0.);
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

/// Whether nothing damps the swings.
bool slips_neutrally(const Machine& machine, std::span<const WalkWindow> windows) {
    if (machine.model == Machine::Model::prism) return false;
    StretchSums sums;
    for (const WalkWindow& window : windows) sums.add(window.sums);
    return std::ranges::all_of(sums.spots, [&](const SpotSums& spot) {
        return static_cast<double>(spot.sticking) <= instants * static_cast<double>(sums.steps);
    });
}

/// Whether first and last third have the same mean force but for swings: those of their windows,
/// and what the momentum of the body can make of the difference.
bool thirds_agree(const Machine& machine, std::span<const WalkWindow> windows) {
    const std::size_t third = windows.size() / 3;
    if (third < 1) return false;
    const auto before = windows.first(third), after = windows.last(third);
    const MeanForce first = mean_of(before), last = mean_of(after);
    const double swings = swing_error(before) + swing_error(after) +
                          momentum_bound(machine, before) / first.time +
                          momentum_bound(machine, after) / last.time;
    return std::abs(last.force - first.force) <= swings + rounding * sliding_force(machine);
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
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
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
    const std::size_t third = windows.size() / 3;
    if (third == 0 || slips_neutrally(machine, windows)) return swings;
    const double mean = mean_of(windows).force, end = mean_of(windows.last(third)).force,
                 before = mean_of(windows.last(2 * third).first(third)).force;
    return std::max(swings, std::abs(end - mean) + 2 * std::abs(end - before));
}

bool is_evenly_pulled(const Machine& machine, std::span<const WalkWindow> windows) {
    const std::size_t half = windows.size() / 2;
    return thirds_agree(machine, windows) && thirds_agree(machine, windows.subspan(half));
}

bool moves_with_base(const Machine& machine, const StretchSums& sums) {
    constexpr double near = 0.01;
    const double base = machine.kappas.kappa6, steps = static_cast<double>(sums.steps);
    return !(base > 0) || std::ranges::all_of(sums.spots, [&](const SpotSums& spot) {
        return std::abs(spot.velocity / steps - base) <= near * base;
    });
}

double loading_time(const Machine& machine) {
    double stiffness = 0;
    for (const Spot& spot : spots_of(machine))
        stiffness += spot_force(machine, spot, {.tangential = 1}).tangential;
    const double way = sliding_force(machine) * (1 / machine.kappas.kappa1 + 1 / stiffness);
    return way / machine.kappas.kappa6;
}

}  // namespace tricontact::dynamics

#include "walking/run/walk_judge.h"

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "statistics/initial_sequence.h"
#include "statistics/stationarity.h"
#include "walking/run/limit_cycle.h"

namespace tricontact::walking {
namespace {

constexpr double nothing = contact::undefined;

// Vertical vibration over the static displacement that does not count: normal forces, and with them
// friction, differ by no more.
constexpr double still = 0.01;

// The same of a free oscillator where a spot might have been in the air: it would be driven.
constexpr double even = 0.001;

// A chaotic run has to outlive this before chaos counts as what it ends in. Chaos of set B lives
// 1450 on average and then walks; a transient of that life would be missed once in a thousand runs.
constexpr double sustained = 10000;

// Chaos is not what a run ends in either where it may be expected to end by a fall: above one in
// twenty, as intervals are of 95 %, in the time of ten such runs.
constexpr double runs_ahead = 10, likely_fall = 0.05;

double vibration(const WalkWindow& window) {
    return (window.sums.z_max - window.sums.z_min) / 2;
}

/// The force that mu_e and its error are told in; NaN, as they are, where there is no friction.
double unit_force(const Machine& machine) {
    const double sliding = sliding_force(machine);
    return sliding > 0 ? sliding : nothing;
}

/// First of the windows from which on all fulfil a condition; their number if the last does not.
template <class Condition>
std::size_t first_of_end(std::span<const WalkWindow> windows, Condition holds) {
    std::size_t first = windows.size();
    while (first > 0 && holds(windows[first - 1])) --first;
    return first;
}

double greatest_vibration(std::span<const WalkWindow> windows) {
    double greatest = 0;
    for (const WalkWindow& window : windows) greatest = std::max(greatest, vibration(window));
    return greatest;
}

/// Whether no spot can have left the ground: at the highest position with the largest rotation.
bool stays_on_ground(const std::vector<Spot>& spots, double kappa3, const StretchSums& sums) {
    return std::ranges::all_of(spots, [&](const Spot& spot) {
        return std::min(approach(spot, sums.z_min, sums.phi_min / kappa3),
                        approach(spot, sums.z_min, sums.phi_max / kappa3)) > 0;
    });
}

/// First of the windows from which on the body slides without vertical vibration, or with one that
/// is left from the start: while all spots stay on the ground z is a free oscillator, neither
/// driven nor damped by friction. It swings evenly about its rest then, and a jump cannot. None if
/// it does not in the last quarter of the run.
std::optional<std::size_t> first_steady(const Machine& machine,
                                        std::span<const WalkWindow> windows) {
    const double rest = std::abs(static_displacement(machine));
    const double amplitude = vibration(windows.back());
    const std::vector<Spot> spots = spots_of(machine);
    const std::size_t first = first_of_end(windows, [&](const WalkWindow& window) {
        if (vibration(window) <= still * rest) return true;
        const double middle = (window.sums.z_max + window.sums.z_min) / 2;
        const bool pressed = stays_on_ground(spots, machine.kappas.kappa3, window.sums);
        const double bound = (pressed ? still : even) * rest;
        return window.sums.z_min > 0 && std::abs(middle - rest) <= bound &&
               std::abs(vibration(window) - amplitude) <= bound;
    });
    if (first >= windows.size() - windows.size() / 4) return std::nullopt;
    return first;
}

WalkResult judge_windows(const Machine& machine, std::span<const WalkWindow> windows, Regime regime,
                         std::size_t first) {
    const auto judged = windows.subspan(first);
    WalkResult result{.regime = regime};
    take_statistics(machine, total(judged), result);
    result.transient = judged.front().begin;
    result.observed = judged.back().end - judged.front().begin;
    return result;
}

/// Flutter begins small: a vibration that still grows is not what the run ends in.
bool grows(const Machine& machine, std::span<const WalkWindow> windows) {
    const std::size_t half = windows.size() / 2;
    const double before = greatest_vibration(windows.first(half)),
                 after = greatest_vibration(windows.subspan(half));
    constexpr double rounding = 1e-9, growth = 0.1;
    return after > std::max((1 + growth) * before, rounding * static_displacement(machine));
}

/// Sliding is linearly neutral: what the transient leaves behind swings on undamped, its integral
/// stays bounded, and the error of a mean falls as one over the time, not over its square root.
/// The spring has to be loaded first, which takes the base a way of mu kappa4 (1/kappa1 + 1/2).
WalkResult judge_steady(const Machine& machine, std::span<const WalkWindow> windows,
                        std::size_t quiet) {
    const auto judged = windows.subspan(quiet);
    if (machine.kappas.kappa6 > 0 && only_sticks(judged.last((judged.size() + 1) / 2))) {
        // The base moves and nothing slides: the spring takes up what the base moves. Its force is
        // a load, which friction has not yet answered.
        WalkResult result = judge_windows(machine, windows, Regime::sticking, quiet);
        result.mu_e = result.mu_e_error = nothing;
        return result;
    }
    const std::size_t loaded = quiet + first_loaded(machine, judged);
    const bool enough = 4 * (windows.size() - loaded) >= windows.size();
    const std::size_t first = enough ? loaded : quiet;
    const auto rest = windows.subspan(first);
    WalkResult result = judge_windows(machine, windows, Regime::steady, first);
    result.mu_e_error = rest.size() > 1 ? mean_error(machine, rest) / unit_force(machine) : nothing;
    const bool pulled = enough && is_evenly_pulled(machine, rest) && moves_with_base(machine, rest);
    // What rises has mu_e = 1, all spots sliding, ahead.
    if (!pulled) result.mu_e_error = std::max(result.mu_e_error, std::abs(1 - result.mu_e));
    result.transient_over = pulled && !grows(machine, rest);
    return result;
}

/// Whether the extremes of two stretches agree to a hundredth of the amplitudes.
bool same_extremes(const StretchSums& a, const StretchSums& b) {
    constexpr double near = 0.01;
    const double z = near * (b.z_max - b.z_min), phi = near * (b.phi_max - b.phi_min);
    return std::abs(a.z_min - b.z_min) <= z && std::abs(a.z_max - b.z_max) <= z &&
           std::abs(a.phi_min - b.phi_min) <= phi && std::abs(a.phi_max - b.phi_max) <= phi;
}

/// Whether an extreme of the windows is on its way: returns repeat to the error of the integration,
/// which hides what is slower.
bool extremes_creep(std::span<const WalkWindow> windows) {
    constexpr std::size_t fewest = 12;  // thirds of fewer are apart by chance
    if (windows.size() < fewest) return false;
    const StretchSums& sums = windows.back().sums;
    const double z = sums.z_max - sums.z_min, phi = sums.phi_max - sums.phi_min;
    const auto moves = [&](double StretchSums::*extreme, double range) {
        constexpr double error = 1e-6;  // step^2
        std::vector<std::vector<double>> values;
        for (const WalkWindow& window : windows) values.push_back({window.sums.*extreme});
        return statistics::creeps(values, error * range);
    };
    return moves(&StretchSums::z_min, z) || moves(&StretchSums::z_max, z) ||
           moves(&StretchSums::phi_min, phi) || moves(&StretchSums::phi_max, phi);
}

WalkResult judge_cycle(const Machine& machine, std::span<const WalkWindow> windows,
                       const LimitCycle& cycle) {
    WalkResult result{.regime = Regime::limit_cycle};
    take_statistics(machine, cycle.sums, result);
    result.mu_e = cycle.spring_force / unit_force(machine);
    result.mu_e_error = cycle.spring_force_drift / unit_force(machine);
    result.period = cycle.period;
    result.period_error = cycle.period_drift;
    result.section_points = cycle.section_points;
    const std::size_t first = first_of_end(
        windows, [&](const WalkWindow& window) { return same_extremes(window.sums, cycle.sums); });
    result.transient =
        first < windows.size() ? std::min(windows[first].begin, cycle.begin) : cycle.begin;
    result.observed = cycle.n_periods * cycle.period;
    result.transient_over = cycle.settled && !extremes_creep(windows.subspan(first));
    if (!result.transient_over)
        result.mu_e_error = std::max(result.mu_e_error, std::abs(1 - result.mu_e));
    return result;
}

WalkResult judge_chaos(const Machine& machine, std::span<const WalkWindow> windows) {
    std::vector<double> forces;
    for (const WalkWindow& window : windows) forces.push_back(mean_force(window));
    const std::size_t first = statistics::transient_values(forces);
    WalkResult result = judge_windows(machine, windows, Regime::chaotic, first);
    const auto rest = std::span(forces).subspan(first);
    result.transient_over =
        2 * first < forces.size() && result.observed >= sustained && statistics::stationary(rest) &&
        moves_with_base(machine, windows.subspan(first)) &&
        expected_falls(machine, windows.subspan(first), runs_ahead) < likely_fall;
    if (result.transient_over) {
        result.mu_e_error = statistics::initial_sequence_mean(rest).error / unit_force(machine);
        return result;
    }
    // What it ends in may be like any stretch of it.
    const double mean = result.mu_e * unit_force(machine);
    double greatest = 0;
    for (const double force : forces) greatest = std::max(greatest, std::abs(force - mean));
    result.mu_e_error = forces.size() > 1 ? greatest / unit_force(machine) : nothing;
    return result;
}

WalkResult judge_tilting(const Machine& machine, const WalkEvidence& evidence) {
    WalkResult result{.regime = Regime::tilting};
    if (!evidence.windows.empty()) take_statistics(machine, total(evidence.windows), result);
    // Means of a fall depend on when it is stopped.
    result.mu_e = result.mu_e_error = result.kinetic_energy = nothing;
    for (WalkResult::Spot& spot : result.spots) spot = {nothing, nothing};
    result.transient = *evidence.tilting_time;
    result.tilting_time = evidence.tilting_time;
    return result;
}

}  // namespace

void take_statistics(const Machine& machine, const StretchSums& sums, WalkResult& result) {
    const double n = static_cast<double>(sums.steps), rest = static_displacement(machine);
    result.mu_e = sums.spring_force / n / unit_force(machine);
    result.z_min_ratio = sums.z_min / rest;
    result.z_max_ratio = sums.z_max / rest;
    result.phi_min = sums.phi_min;
    result.phi_max = sums.phi_max;
    result.kinetic_energy = sums.kinetic_energy / n / (machine.kappas.kappa4 * rest);
    for (const SpotSums& spot : sums.spots)
        result.spots.push_back(
            {static_cast<double>(spot.sticking) / n, correlation(spot, sums.steps)});
}

std::int64_t window_steps(std::int64_t n_steps, double step) {
    constexpr std::int64_t n_windows = 200;
    constexpr double shortest = 20;
    return std::max(
        {n_steps / n_windows, static_cast<std::int64_t>(shortest / step), std::int64_t{1}});
}

bool may_repeat(const Machine& machine, std::span<const WalkWindow> windows) {
    if (first_steady(machine, windows)) return false;
    const double length = windows.front().end - windows.front().begin;
    const auto half = static_cast<std::size_t>(std::max(1., std::round(judged_time / 2 / length)));
    if (windows.size() < 2 * half) return true;
    const auto end = windows.last(2 * half);
    return same_extremes(total(end.first(half)), total(end.last(half)));
}

WalkResult judge(const Machine& machine, const WalkEvidence& evidence) {
    if (evidence.tilting_time) return judge_tilting(machine, evidence);
    if (const auto first = first_steady(machine, evidence.windows))
        return judge_steady(machine, evidence.windows, *first);
    const auto cycle = find_limit_cycle(machine, evidence.returns, evidence.step);
    if (cycle && cycle->slides) return judge_cycle(machine, evidence.windows, *cycle);
    return judge_chaos(machine, evidence.windows);
}

}  // namespace tricontact::walking

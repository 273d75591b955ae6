#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

#include "report/format.h"
#include "walking/machine/motion.h"
#include "walking/report/walk_document.h"
#include "walking/run/walk_judge.h"
#include "walking/run/walk_readings.h"

namespace tricontact::walking {

namespace {

using Standing = report::Verdict::Standing;
using report::significant;

std::string friction(const WalkResult& result) {
    return fmt::format("μ_e = {}", report::with_error(result.mu_e, result.mu_e_error));
}

/// Share of time of the spot that sticks most; 0 where sticking takes nothing from the force of
/// sliding that the error of the mean would not hide: in instants in which a swing comes to rest.
double longest_sticking(const WalkResult& result) {
    double longest = 0;
    if (std::abs(1 - result.mu_e) > result.mu_e_error)
        for (const WalkResult::Spot& spot : result.spots)
            longest = std::max(longest, spot.stick_time);
    return longest;
}

/// How much friction vibration takes away, where that is more than the error.
std::string reduction(const WalkResult& result) {
    const double saved = 1 - result.mu_e;
    return saved > result.mu_e_error
               ? fmt::format(", {} less friction than steady sliding", report::share(saved, 3))
               : "";
}

std::string fall(const WalkReport& report) {
    const WalkResult& result = report.walk.result;
    const Machine& machine = report.walk_case.machine;
    const double mu = machine.kappas.kappa5;
    const double limit = critical_friction(machine);
    return fmt::format(
        "Falls over at t = {}: |φ| exceeds {}. μ = {} lies {} μ_c = {}, above which a sliding body "
        "falls over its leading spot.",
        significant(result.tilting_time), significant(tilting_limit(machine), 3),
        report::as_given(mu), mu > limit ? "above" : "below", significant(limit));
}

/// A machine that is excited while its base stands still.
std::string excited(const WalkReport& report) {
    const WalkResult& result = report.walk.result;
    const Machine& machine = report.walk_case.machine;
    const std::string ways = result.regime == Regime::shakedown    ? "shakes down"
                             : result.regime == Regime::ratcheting ? "ratchets"
                                                                   : "walks";
    std::string text = fmt::format(
        "Pulled by f = {} of its friction, it {}: its shift per period of the excitation is {} "
        "U_max, a spot is in the air for {} of the time.",
        significant(result.mu_e, 3), ways,
        report::with_error(result.drift->per_period, result.drift->error),
        report::share(result.drift->airborne, 3));
    const auto& [moment, force, frequency] = machine.excitation;
    if (machine.model != Machine::Model::two_spot || (moment > 0 && force > 0)) return text;
    const DriftLimits limits = drift_limits(machine, result.mu_e);
    text += fmt::format(
        " The excitation is m = {} of the weight; quasi-static, the machine shakes down up to {} "
        "and a spot leaves the ground above {}.",
        report::as_given(std::max(moment, force) / machine.kappas.kappa4),
        significant(limits.ratcheting, 3), significant(limits.lift_off, 3));
    return text;
}

/// A machine that has not begun to slide: nothing is known of its friction.
report::Verdict loading(const WalkReport& report) {
    const Machine& machine = report.walk_case.machine;
    const double load =
        spring_force(machine, report.walk.tail.back().motion) / sliding_force(machine);
    return {Standing::not_resolved,
            fmt::format("Does not slide yet: the spots stick, and the base still loads the spring, "
                        "by T = {} to {} of the force of steady sliding. That takes until t = {} "
                        "at least; a longer [time] end is needed for its friction.",
                        significant(report.walk_case.time.end, 5), report::share(load, 3),
                        significant(loading_time(machine), 3))};
}

/// The run does not tell what it ends in, and why.
report::Verdict too_short(const WalkReport& report) {
    const WalkResult& result = report.walk.result;
    const Machine& machine = report.walk_case.machine;
    const double rotation = std::max(-result.phi_min, result.phi_max) / tilting_limit(machine);
    std::string reason = result.regime == Regime::steady
                             ? "its mean force or its vibration still changes"
                             : "the motion is chaotic";
    if (result.regime == Regime::chaotic && rotation > 0.2)
        reason += ", and |φ| has come to " + report::share(rotation) + " of where it falls over";
    return {
        Standing::not_resolved,
        fmt::format("Too short: the transient was not over by T = {}, {}. So far {}, whose error "
                    "covers what it may still become; a longer [time] end is needed.",
                    significant(report.walk_case.time.end, 5), reason, friction(result))};
}

/// The transient is over: z is still, or swings as the start left it, the spring force has no trend
/// and the spots move.
std::string steady(const WalkReport& report) {
    const WalkResult& result = report.walk.result;
    const Machine& machine = report.walk_case.machine;
    if (machine.kappas.kappa6 == 0)
        return fmt::format(
            "The base rests: a mean spring force of {} of that of steady sliding holds the body "
            "from t = {} on.",
            report::with_error(result.mu_e, result.mu_e_error), significant(result.transient));
    const double sticking = longest_sticking(result);
    const std::string ways = sticking > 0 ? "Slides, a spot sticking for up to " +
                                                report::share(sticking, 3) + " of the time"
                                          : "Slides steadily";
    return fmt::format(
        "{}: {}. From t = {} on the height does not vibrate by itself and the mean spring force "
        "has no trend.",
        ways, friction(result), significant(result.transient));
}

report::Verdict outcome(const WalkReport& report) {
    const WalkResult& result = report.walk.result;
    if (result.regime == Regime::tilting) return {.sentence = fall(report)};
    if (result.drift) return {.sentence = excited(report)};
    if (report.walk_case.machine.kappas.kappa5 == 0)
        return {Standing::finding, "Without friction, μ = 0, there is none to reduce."};
    if (result.regime == Regime::sticking) return loading(report);
    if (!result.transient_over) return too_short(report);
    if (result.regime == Regime::limit_cycle)
        return {Standing::finding,
                fmt::format("Walks in a limit cycle of period {}: {}{}. Mean over whole periods; "
                            "the transient ends before t = {}.",
                            report::with_error(*result.period, result.period_error, 5),
                            friction(result), reduction(result), significant(result.transient))};
    if (result.regime == Regime::steady) return {.sentence = steady(report)};
    // Without an end in a time T the mean life is T/3 or more, with a probability of 1 - exp(-3).
    return {
        Standing::finding,
        fmt::format(
            "Chaotic to the end: {}{}; 95 % interval by its autocorrelation over the last "
            "{}. It is that of this chaos, whose mean life is above {} (95 %); whether it "
            "ends later is not resolved by a run. Single numbers of a chaotic motion mean nothing.",
            friction(result), reduction(result), significant(result.observed),
            significant(result.observed / 3, 2))};
}

std::string jump(const WalkReport& report) {
    const WalkResult& result = report.walk.result;
    if (result.z_min_ratio >= 0)
        return fmt::format(
            "The body does not jump: its highest position is z = {} z_stat, downwards from where "
            "the spots are free.",
            significant(result.z_min_ratio));
    std::string text = fmt::format("The body jumps {} static displacements high",
                                   significant(-result.z_min_ratio));
    if (result.regime == Regime::chaotic)
        text +=
            fmt::format(" at most within {}; the longer chaos lasts, the higher its highest jump",
                        significant(result.observed));
    if (const auto& phases = report.walk.phases; phases && phases->airborne > 0)
        text += fmt::format(
            ": it is in the air for {} of a period, in which it makes {} of its way",
            report::share(phases->airborne, 3), report::share(phases->airborne_advance, 3));
    return text + ".";
}

/// Wetter (2016), section 4.2.2: where friction is much reduced, the spots' velocities and normal
/// deflections have correlations below -0.5.
std::string walking(const WalkReport& report) {
    const std::vector<SpotStatistics> spots = spot_statistics(report.walk);
    if (spots.empty() || spots.size() > most_spots) return {};
    const auto told = [&](const SpotStatistics& spot) {
        const auto& [r, error] = spot.correlation;
        return fmt::format("r_{} = {}", &spot - spots.data() + 1,
                           std::isnan(error) ? significant(r, 3) : report::with_error(r, error));
    };
    constexpr double strong = 0.5;
    // NaN, of a spot that never touches, is neither.
    const auto of_all = [&](auto holds) {
        return std::ranges::all_of(
            spots, [&](const SpotStatistics& spot) { return holds(spot.correlation.value); });
    };
    std::string text = "Correlations of velocity and normal deflection of the spots: ";
    if (of_all([](double r) { return r < -strong; }))
        text = "Spots move where they press little, micro-walking; correlations ";
    else if (of_all([](double r) { return std::abs(r) <= strong; }))
        text = "How fast spots move depends little on how hard they press, correlations ";
    return fmt::format("{}{}.", text, fmt::join(spots | std::views::transform(told), ", "));
}

/// Chaos: nearby trajectories diverge.
std::string predictable(const WalkResult& result) {
    if (!result.lyapunov) return {};
    const auto& [rate, error] = *result.lyapunov;
    if (!std::isfinite(rate)) return {};
    std::string text =
        fmt::format("Largest Lyapunov exponent {} √(k_x/m): ", report::with_error(rate, error));
    if (rate > error)
        text += fmt::format("nearby trajectories diverge tenfold in {}, chaos.",
                            significant(std::numbers::ln10 / rate, 2));
    else if (rate < -error)
        text += "nearby trajectories converge.";
    else
        text += "nearby trajectories neither diverge nor converge.";
    return text;
}

std::string vibrates(const WalkReport& report, const Vibration& vibration) {
    const auto& [frequency, error] = vibration.characteristic;
    std::string text = fmt::format("The spring force vibrates at {} cycles per √(m/k_x)",
                                   report::with_error(frequency, error));
    if (const auto& dimensional = report.walk_case.dimensional) {
        const double second = 1 / characteristic_time(*dimensional);
        text += fmt::format(", {} Hz", report::with_error(frequency * second, error * second));
    }
    text += fmt::format("; in free flight it would be {}.", significant(vibration.free_flight, 3));
    const bool steady = report.walk.result.regime == Regime::steady;
    if (steady && longest_sticking(report.walk.result) == 0 &&
        is_neutral(sliding_stability(report.walk_case.machine)))
        text += " Sliding is linearly neutral: nothing damps this vibration, nor feeds it.";
    if (!steady && std::isfinite(vibration.instability))
        text += fmt::format(
            " Unstable, variance above {}: {} % of the recorded end.",
            report::as_given(instability_threshold),
            report::with_error(100 * vibration.instability, 100 * instability_error(vibration), 3));
    return text;
}

}  // namespace

std::vector<report::Verdict> walk_verdicts(const WalkReport& report,
                                           const std::optional<Vibration>& vibration) {
    const WalkResult& result = report.walk.result;
    std::vector<report::Verdict> verdicts{outcome(report)};
    const auto say = [&](const std::string& sentence) {
        if (!sentence.empty()) verdicts.push_back({.sentence = sentence});
    };
    if (result.regime == Regime::tilting || result.regime == Regime::sticking || result.drift)
        return verdicts;
    if (result.regime != Regime::steady && result.transient_over) {
        say(jump(report));
        say(walking(report));
    }
    say(predictable(result));
    if (vibration && std::isfinite(vibration->characteristic.frequency))
        say(vibrates(report, *vibration));
    return verdicts;
}

}  // namespace tricontact::walking

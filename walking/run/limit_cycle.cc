#include "walking/run/limit_cycle.h"

#include <algorithm>
#include <cmath>

#include "statistics/stationarity.h"
#include "walking/machine/motion.h"
#include "walking/run/walk_judge.h"

namespace tricontact::walking {
namespace {

// Chaos comes near its past now and then, but does not stay: with a Lyapunov exponent of 0.2 two
// returns a tolerance apart are a hundred times as far six returns later. 48 returns hold three
// periods of the longest cycle looked for.
constexpr std::size_t returns_looked_at = 48, longest = 16, fewest_returns = 12;

/// Adds a motion to a point; points of such are as far from each other as `distance` says.
void append_motion(const Machine& machine, const Motion& motion, std::vector<double>& point) {
    const double rotational = std::sqrt(machine.kappas.kappa7) / machine.kappas.kappa3;
    point.insert(point.end(),
                 {motion.x - motion.base, motion.z, rotational * motion.phi, motion.x_velocity,
                  motion.z_velocity, rotational * motion.phi_velocity});
    for (const SpotDeflection& spot : motion.spots)
        point.insert(point.end(), {spot.tangential, spot.flank});
}

/// Periods of so many returns, counted from the end, each as a point.
std::vector<std::vector<double>> periods_of(const Machine& machine,
                                            std::span<const SectionReturn> returns,
                                            std::size_t points) {
    std::vector<std::vector<double>> periods(returns.size() / points);
    const auto whole = returns.last(periods.size() * points);
    for (std::size_t i = 0; i < whole.size(); ++i)
        append_motion(machine, whole[i].motion, periods[i / points]);
    return periods;
}

/// Greatest distance of returns from the one `points` earlier.
double repetition(const Machine& machine, std::span<const SectionReturn> returns,
                  std::size_t points) {
    double greatest = 0;
    for (std::size_t i = points; i < returns.size(); ++i)
        greatest =
            std::max(greatest, distance(machine, returns[i].motion, returns[i - points].motion));
    return greatest;
}

/// Mean f_s from the first return to the last one. The steps between them miss or exceed the time
/// by parts of a step, in which f_s is that of the section.
double mean_spring_force(const Machine& machine, std::span<const SectionReturn> returns,
                         double step) {
    const Motion& begin = returns.front().motion;
    const double steps = (returns.back().motion.time - begin.time) / step;
    const StretchSums sums = total(returns.first(returns.size() - 1));
    const double missed = steps - static_cast<double>(sums.steps);
    return (sums.spring_force + missed * spring_force(machine, begin)) / steps;
}

/// Whether each spot slides farther in a period than the returns miss.
bool slides(const Machine& machine, const LimitCycle& cycle, double miss) {
    return !(machine.kappas.kappa6 > 0) ||
           std::ranges::all_of(cycle.sums.spots, [&](const SpotSums& spot) {
               return spot.velocity / static_cast<double>(cycle.sums.steps) * cycle.period > miss;
           });
}

double mean_period(std::span<const SectionReturn> returns, std::size_t points) {
    return (returns.back().motion.time - returns.front().motion.time) /
           static_cast<double>((returns.size() - 1) / points);
}

}  // namespace

double distance(const Machine& machine, const Motion& a, const Motion& b) {
    std::vector<double> from, to;
    append_motion(machine, a, from);
    append_motion(machine, b, to);
    return statistics::distance(from, to);
}

LimitCycle mean_cycle(const Machine& machine, std::span<const SectionReturn> returns, int points,
                      double step) {
    const std::size_t k = static_cast<std::size_t>(points), n = (returns.size() - 1) / k;
    const auto whole = returns.last(n * k + 1);
    const auto before = whole.first(n / 2 * k + 1), after = whole.subspan(n / 2 * k);
    return {.section_points = points,
            .n_periods = static_cast<int>(n),
            .begin = whole.front().motion.time,
            .period = mean_period(whole, k),
            .spring_force = mean_spring_force(machine, whole, step),
            .period_drift = std::abs(mean_period(after, k) - mean_period(before, k)),
            .spring_force_drift = std::abs(mean_spring_force(machine, after, step) -
                                           mean_spring_force(machine, before, step)),
            .sums = total(whole.first(n * k))};
}

std::optional<LimitCycle> find_limit_cycle(const Machine& machine,
                                           std::span<const SectionReturn> returns, double step) {
    const auto end = returns.last(std::min(returns.size(), returns_looked_at));
    if (end.size() < fewest_returns) return std::nullopt;
    const StretchSums sums = total(end);
    const double size = std::sqrt(2 * sums.kinetic_energy / static_cast<double>(sums.steps));
    // Where contacts change between two steps, Verlet errs by the order of step^2; measured on the
    // cycles of the map of kappa8 and mu, returns repeat to 2.5 step^2 at worst. On the way to a
    // cycle, or along what is none, they may be farther apart.
    // Coarse steps may not make anything look alike: above 0.01 a motion does not repeat.
    constexpr double misses = 100;
    const double tolerance = std::clamp(misses * step * step, 1e-9, 0.01) * size;
    for (std::size_t points = 1; points <= std::min(longest, end.size() / 3); ++points)
        if (const double miss = repetition(machine, end, points); miss <= tolerance) {
            LimitCycle cycle = mean_cycle(machine, end, static_cast<int>(points), step);
            cycle.slides = slides(machine, cycle, miss);
            // What the integration scatters, step^2 in each return of a period.
            const double error = tolerance / misses * std::sqrt(static_cast<double>(points));
            cycle.settled = !statistics::creeps(periods_of(machine, end, points), error);
            return cycle;
        }
    return std::nullopt;
}

}  // namespace tricontact::walking

#include "dynamics/limit_cycle.h"

#include <algorithm>
#include <cmath>

#include "dynamics/forces.h"

namespace tricontact::dynamics {
namespace {

// Chaos comes near its past now and then, but does not stay: with a Lyapunov exponent of 0.2 two
// returns a tolerance apart are a hundred times as far six returns later. 48 returns hold three
// periods of the longest cycle looked for.
constexpr std::size_t judged = 48, longest = 16, fewest = 12;

StretchSums total(std::span<const SectionReturn> returns) {
    StretchSums sums;
    for (const SectionReturn& r : returns) sums.add(r.sums);
    return sums;
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

/// Whether the returns have come to the cycle. A motion that creeps along a line repeats itself
/// from return to return, and not after many: it goes as far in the second half of their time as in
/// the first, in the same direction. What the integration scatters does not add up.
bool is_settled(const Machine& machine, std::span<const SectionReturn> returns, std::size_t points,
                double error) {
    const std::size_t half = (returns.size() - 1) / points / 2 * points;
    const auto whole = returns.last(2 * half + 1);
    const Motion &first = whole.front().motion, &middle = whole[half].motion,
                 &last = whole.back().motion;
    const double before = distance(machine, first, middle), after = distance(machine, middle, last);
    const bool straight = distance(machine, first, last) > 0.9 * (before + after);
    return !straight || after <= std::max({error, before / 2, repetition(machine, whole, points)});
}

double mean_period(std::span<const SectionReturn> returns, std::size_t points) {
    return (returns.back().motion.time - returns.front().motion.time) /
           static_cast<double>((returns.size() - 1) / points);
}

}  // namespace

double distance(const Machine& machine, const Motion& a, const Motion& b) {
    const double kappa3 = machine.kappas.kappa3;
    const double rotational = machine.kappas.kappa7 / (kappa3 * kappa3);
    const auto squared = [](double difference) { return difference * difference; };
    double sum = squared((a.x - a.base) - (b.x - b.base)) + squared(a.z - b.z) +
                 rotational * squared(a.phi - b.phi) + squared(a.x_velocity - b.x_velocity) +
                 squared(a.z_velocity - b.z_velocity) +
                 rotational * squared(a.phi_velocity - b.phi_velocity);
    for (std::size_t i = 0; i < a.spots.size(); ++i)
        sum += squared(a.spots[i].tangential - b.spots[i].tangential) +
               squared(a.spots[i].flank - b.spots[i].flank);
    return std::sqrt(sum);
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
    const auto end = returns.last(std::min(returns.size(), judged));
    if (end.size() < fewest) return std::nullopt;
    const StretchSums sums = total(end);
    const double size = std::sqrt(2 * sums.kinetic_energy / static_cast<double>(sums.steps));
    // Where contacts change between two steps, Verlet errs by the order of step^2; measured on the
    // cycles of the map of kappa8 and mu, returns repeat to 2.5 step^2 at worst. On the way to a
    // cycle, or along what is none, they may be farther apart.
    // Coarse steps may not make anything look alike: above 0.01 a motion does not repeat.
    const double tolerance = std::clamp(100 * step * step, 1e-9, 0.01) * size;
    for (std::size_t points = 1; points <= std::min(longest, end.size() / 3); ++points)
        if (repetition(machine, end, points) <= tolerance) {
            LimitCycle cycle = mean_cycle(machine, end, static_cast<int>(points), step);
            cycle.settled = is_settled(machine, end, points, tolerance / 100);
            return cycle;
        }
    return std::nullopt;
}

}  // namespace tricontact::dynamics

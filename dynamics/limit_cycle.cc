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

/// Mean f_s between two returns, `sums` over the steps between them. These miss or exceed the time
/// between by parts of a step, in which f_s is that of the section.
double mean_spring_force(const Machine& machine, const Motion& begin, const Motion& end,
                         const StretchSums& sums, double step) {
    const double steps = (end.time - begin.time) / step;
    const double missed = steps - static_cast<double>(sums.steps);
    return (sums.spring_force + missed * spring_force(machine, begin)) / steps;
}

LimitCycle cycle_of(const Machine& machine, std::span<const SectionReturn> returns,
                    std::size_t points, double step) {
    const std::size_t n = (returns.size() - 1) / points;
    const auto whole = returns.last(n * points + 1);
    const auto begin = [&](std::size_t period) -> const Motion& {
        return whole[period * points].motion;
    };
    LimitCycle cycle{.section_points = static_cast<int>(points),
                     .n_periods = static_cast<int>(n),
                     .period = (begin(n).time - begin(0).time) / static_cast<double>(n),
                     .sums = total(whole.first(n * points)),
                     .begin = begin(0).time};
    cycle.spring_force = mean_spring_force(machine, begin(0), begin(n), cycle.sums, step);
    for (std::size_t i = 0; i < n; ++i) {
        const StretchSums sums = total(whole.subspan(i * points, points));
        const double period = begin(i + 1).time - begin(i).time;
        const double force = mean_spring_force(machine, begin(i), begin(i + 1), sums, step);
        cycle.period_scatter = std::max(cycle.period_scatter, std::abs(period - cycle.period));
        cycle.spring_force_scatter =
            std::max(cycle.spring_force_scatter, std::abs(force - cycle.spring_force));
    }
    return cycle;
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

std::optional<LimitCycle> find_limit_cycle(const Machine& machine,
                                           std::span<const SectionReturn> returns, double step) {
    const auto end = returns.last(std::min(returns.size(), judged));
    if (end.size() < fewest) return std::nullopt;
    const StretchSums sums = total(end);
    const double size = std::sqrt(2 * sums.kinetic_energy / static_cast<double>(sums.steps));
    // Where contacts change between two steps, Verlet errs by the order of step^2; measured on the
    // cycles of the map of kappa8 and mu, returns repeat to 2.5 step^2 at worst.
    const double tolerance = std::max(100 * step * step, 1e-9) * size;
    for (std::size_t points = 1; points <= std::min(longest, end.size() / 3); ++points)
        if (repetition(machine, end, points) <= tolerance)
            return cycle_of(machine, end, points, step);
    return std::nullopt;
}

}  // namespace tricontact::dynamics

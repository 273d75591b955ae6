#include "walking/report/motion_series.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "walking/machine/forces.h"

namespace tricontact::walking {

MotionSeries motion_series(const Machine& machine, std::span<const Snapshot> snapshots) {
    MotionSeries series;
    const double load = machine.kappas.kappa5 * machine.kappas.kappa4;
    const double rest = static_displacement(machine), sliding = sliding_force(machine);
    for (const Snapshot& snapshot : snapshots) {
        const Motion& motion = snapshot.motion;
        series.time.push_back(motion.time - snapshots.front().motion.time);
        series.displacement.push_back((motion.x - motion.base) / load);
        series.z.push_back(motion.z / rest);
        series.phi.push_back(motion.phi / (machine.kappas.kappa3 * load));
        series.force.push_back(spring_force(machine, motion) / sliding);
    }
    return series;
}

double sampling_interval(const Walk& walk) {
    if (walk.tail.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    return walk.tail[1].motion.time - walk.tail[0].motion.time;
}

std::span<const Snapshot> last_swings(const Walk& walk) {
    constexpr double shown = 10, without_period = 20;
    const double period = walk.result.period.value_or(0);
    const double length = period > 0 ? period * std::ceil(shown / period) : without_period;
    const double steps = std::round(length / sampling_interval(walk));  // NaN: one snapshot or none
    const std::size_t n = steps >= 0 ? static_cast<std::size_t>(steps) + 1 : walk.tail.size();
    return std::span(walk.tail).last(std::min(n, walk.tail.size()));
}

}  // namespace tricontact::walking

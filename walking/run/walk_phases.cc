#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/base/special_values.h"
#include "walking/run/walk.h"

namespace tricontact::walking {
namespace {

bool airborne(const Snapshot& snapshot) {
    return std::ranges::count(snapshot.spots, SpotState::released) == std::ssize(snapshot.spots);
}

/// Begin and end of the sticking of a spot about the turning point; NaN where it does not stick
/// there.
std::pair<double, double> stick_about(std::span<const Snapshot> snapshots, std::size_t turning,
                                      std::size_t spot) {
    const auto sticks = [&](std::size_t i) { return snapshots[i].spots[spot] == SpotState::stick; };
    if (!sticks(turning)) return {contact::undefined, contact::undefined};
    std::size_t begin = turning, end = turning;
    while (begin > 0 && sticks(begin - 1)) --begin;
    while (end + 1 < snapshots.size() && sticks(end)) ++end;
    return {snapshots[begin].motion.time, snapshots[end].motion.time};
}

void find_jump(std::span<const Snapshot> period, double rest, WalkPhases& phases) {
    const auto jump = std::find_if(period.begin(), period.end(), airborne);
    const auto landing = std::find_if_not(jump, period.end(), airborne);
    phases.jump = jump != period.end() ? jump->motion.time : contact::undefined;
    phases.landing = landing != period.end() ? landing->motion.time : contact::undefined;
    for (auto i = jump; i != landing; ++i)
        phases.jump_height = std::max(phases.jump_height, -i->motion.z / rest);
}

}  // namespace

std::optional<WalkPhases> phases_of(const Machine& machine, std::span<const Snapshot> snapshots,
                                    double period) {
    if (snapshots.size() < 2) return std::nullopt;
    const double interval = snapshots[1].motion.time - snapshots[0].motion.time;
    const auto n = static_cast<std::size_t>(std::llround(period / interval));
    if (n == 0 || snapshots.size() < 3 * n + 1) return std::nullopt;
    const auto three = snapshots.last(3 * n + 1);
    const auto deepest = std::max_element(
        three.begin() + static_cast<std::ptrdiff_t>(n),
        three.begin() + static_cast<std::ptrdiff_t>(2 * n),
        [](const Snapshot& a, const Snapshot& b) { return a.motion.z < b.motion.z; });
    const auto turning = static_cast<std::size_t>(deepest - three.begin());

    WalkPhases phases;
    phases.period = period;
    phases.turning_point = deepest->motion.time;
    phases.sticking = phases.release = contact::undefined;
    for (std::size_t spot = 0; spot < deepest->spots.size(); ++spot) {
        const auto [begin, end] = stick_about(three, turning, spot);
        // Also right where nothing has been found yet: fmin and fmax prefer numbers.
        phases.sticking = std::fmin(phases.sticking, begin);
        phases.release = std::fmax(phases.release, end);
    }
    const auto after = three.subspan(turning, n + 1);
    find_jump(after, static_displacement(machine), phases);
    for (std::size_t i = 0; i < n; ++i) {
        if (!airborne(after[i])) continue;
        phases.airborne += 1 / static_cast<double>(n);
        phases.airborne_advance += after[i + 1].motion.x - after[i].motion.x;
    }
    phases.airborne_advance /= after.back().motion.x - after.front().motion.x;
    return phases;
}

}  // namespace tricontact::walking

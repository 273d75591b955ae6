#pragma once

#include <optional>
#include <span>
#include <vector>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// Phases of a period of a limit cycle: Wetter (2016), figures 4.18 and 4.19. Times are those of
/// the snapshots in which a phase begins; NaN where it does not occur.
struct WalkPhases {
    /// About the turning point; a spot that does not stick there has none.
    struct Stick {
        double begin = 0, end = 0;
    };

    double period = 0;          ///< that of the cycle
    double sticking = 0;        ///< (1) the first spot begins to stick
    double turning_point = 0;   ///< (2) deepest, most elastic energy stored
    double release = 0;         ///< (3) the last spot ceases to stick
    double jump = 0;            ///< (4) all spots have left the ground
    double landing = 0;         ///< the first one is back
    std::vector<Stick> sticks;  ///< in the order of spots_of
    double jump_height =
        0;                ///< of the undeformed base over the ground, over the static displacement
    double airborne = 0;  ///< share of time in which no spot touches the ground
    double airborne_advance = 0;  ///< share of the way made in it

    /// The same phases of another period, so much later.
    void shift(double time);
};

/// Phases of the period about the last turning point with a period before and after it. None if
/// the snapshots, consecutive ones at equal intervals, are shorter than three periods.
std::optional<WalkPhases> phases_of(const Machine& machine, std::span<const Snapshot> snapshots,
                                    double period);

}  // namespace tricontact::walking

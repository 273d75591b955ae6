#pragma once

#include <span>
#include <vector>

#include "comparisons/walking/walk_report.h"
#include "dynamics/motion.h"

namespace tricontact::comparisons::walking {

/// Motion over time, normalised as in Wetter (2016), figures 4.5 and 4.6. NaN or infinite without
/// friction.
struct MotionSeries {
    std::vector<double> time;          ///< t* = t - t_0
    std::vector<double> displacement;  ///< (x - x_s)/(mu kappa4)
    std::vector<double> z;             ///< over the static displacement
    std::vector<double> phi;           ///< over mu kappa3 kappa4
    std::vector<double> force;         ///< f_s/(mu kappa4), in the prism over sqrt(2)
};

MotionSeries motion_series(const dynamics::Machine& machine,
                           std::span<const dynamics::Snapshot> snapshots);

/// The end of the run that figures show: whole periods of a limit cycle, some swings otherwise.
std::span<const dynamics::Snapshot> last_swings(const dynamics::Walk& walk);

/// Time between two snapshots of the end of the run; NaN for fewer than two.
double sampling_interval(const dynamics::Walk& walk);

}  // namespace tricontact::comparisons::walking

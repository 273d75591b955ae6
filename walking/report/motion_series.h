#pragma once

#include <span>
#include <vector>

#include "walking/machine/motion.h"
#include "walking/report/walk_report.h"

namespace tricontact::walking {

/// Motion over time, normalised as in Wetter (2016), figures 4.5 and 4.6. NaN or infinite without
/// friction.
struct MotionSeries {
    std::vector<double> time;          ///< t* = t - t_0
    std::vector<double> displacement;  ///< (x - x_s)/(mu kappa4)
    std::vector<double> z;             ///< over the static displacement
    std::vector<double> phi;           ///< over mu kappa3 kappa4
    std::vector<double> force;         ///< f_s/(mu kappa4), in the prism over sqrt(2)
};

MotionSeries motion_series(const Machine& machine, std::span<const Snapshot> snapshots);

/// The end of the run that figures show: whole periods of a limit cycle, some swings otherwise.
std::span<const Snapshot> last_swings(const Walk& walk);

/// Time between two snapshots of the end of the run; NaN for fewer than two.
double sampling_interval(const Walk& walk);

/// Of figures over normalised time.
inline const std::string time_label = "time t* = t - t_0 [√(m/k_x)]";

}  // namespace tricontact::walking

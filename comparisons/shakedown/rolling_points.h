#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparisons/quantities/results.h"
#include "comparisons/resolution/numerical_bar.h"

namespace tricontact::comparisons {

/// One run of a study of rolling under constant loads: a model at one point, on one level of
/// refinement, in steps of one length.
struct RollingRun {
    std::string model;
    std::string
        group;  ///< direction of the load, then all else that is varied but w, f_T and steps
    std::string point;  ///< equal for the runs of one point, whatever the model, level and steps
    double angle = 0;   ///< between rolling and load [rad]
    int level = 0;
    int steps_per_quarter = 1;  ///< 1: turning points only
    Results results;
};

/// A point as one model sees it at infinitely fine resolution, as far as its runs tell.
struct RollingPoint {
    std::string model, group, point;
    double angle = 0;             ///< [rad]
    double amplitude_ratio = 0;   ///< w
    double tangential_ratio = 0;  ///< f_T
    contact::State state = contact::State::undecided;
    /// Of point_quantities(), where the finest run tells them; the bar of a settled shift includes
    /// what was still to come when the run ended. The shift per period, of ratcheting, needs steps
    /// finer than the turning points.
    std::map<const Quantity*, Computed> values = {};

    /// Null where undefined.
    const Computed* find(const Quantity& q) const;
    /// Throws std::out_of_range where undefined.
    const Computed& at(const Quantity& q) const { return values.at(&q); }
};

/// What a point is asked for: shifts in metres and in U_max, limits, stick.
const std::vector<const Quantity*>& point_quantities();

/// What the runs of each model and point say together, in the order of their first runs. Runs
/// without w and f_T in [0, 1] are left out. The state is that of the finest run; a coarser one in
/// whose state a value tells nothing does not count for it.
std::vector<RollingPoint> rolling_points(const std::vector<RollingRun>& runs);

/// "parallel", "perpendicular" or "30 deg": the direction of the load to the rolling.
std::string direction_name(double angle);
/// The two directions that the thesis has formulas for; at 180 deg the rolling is the same.
bool is_parallel(double angle);
bool is_perpendicular(double angle);

}  // namespace tricontact::comparisons

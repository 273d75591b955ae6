#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/numerical_bar.h"

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
    int steps_per_quarter = 1;       ///< 1: turning points only
    nlohmann::ordered_json results;  ///< see point_results
};

/// What became of a point. A coupled contact may keep slipping to and fro without its shift
/// changing any more: the verdict leaves it undecided, its shift has settled all the same.
enum class Behaviour { settled, ratcheting, undecided };

/// A point as one model sees it at infinitely fine resolution, as far as its runs tell. Ratios as
/// in ModelSummary.
struct RollingPoint {
    std::string model, group, point;
    double angle = 0;             ///< [rad]
    double amplitude_ratio = 0;   ///< w
    double tangential_ratio = 0;  ///< f_T
    Behaviour behaviour = Behaviour::undecided;
    Computed static_shift = {};  ///< u_stat
    /// u_sd; the bar includes what was still to come when the run ended. Empty unless settled.
    std::optional<Computed> settled_shift = {};
    /// c_sd/a of a line contact; empty unless it shook down.
    std::optional<Computed> stick = {};
    /// Du of the last period. Empty unless ratcheting in steps finer than the turning points.
    std::optional<Computed> increment = {};
    Computed limit = {};  ///< f_T,lim from the model's own pressures
};

/// What the runs of each model and point say together, in the order of their first runs. Runs
/// without w and f_T in [0, 1] are left out. Behaviour is that of the finest run; coarser ones
/// that behave otherwise do not count for its value.
std::vector<RollingPoint> rolling_points(const std::vector<RollingRun>& runs);

/// "parallel", "perpendicular" or "30 deg": the direction of the load to the rolling.
std::string direction_name(double angle);
/// The two directions that the thesis has formulas for; at 180 deg the rolling is the same.
bool is_parallel(double angle);
bool is_perpendicular(double angle);

}  // namespace tricontact::comparisons

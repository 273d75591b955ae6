#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "comparisons/quantities/results.h"
#include "comparisons/resolution/refinement.h"

namespace tricontact::comparisons {

/// One run of a study of rolling under constant loads: a model at one point, on one level of
/// refinement, in steps of one length.
struct RollingRun {
    std::string model;
    std::string group;  ///< direction of the load, then all that varies but w, f_T and steps
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
    /// Of point_quantities, where the finest run tells them; the bar of a settled shift includes
    /// what was still to come when the run ended. The shift per period, of ratcheting, needs steps
    /// finer than the turning points.
    ByQuantity<Computed> values = {};

    const Computed* find(const Quantity& q) const { return found(values, &q); }  ///< or null
    /// Throws std::out_of_range where undefined.
    const Computed& at(const Quantity& q) const { return values.at(&q); }
};

/// What a point is asked for: shifts in metres and in U_max, limits, stick.
inline constexpr std::array point_quantities{&quantities::static_shift,
                                             &quantities::static_shift_ratio,
                                             &quantities::settled_shift,
                                             &quantities::settled_shift_ratio,
                                             &quantities::shift_increment,
                                             &quantities::shift_increment_ratio,
                                             &quantities::limit_tangential_ratio,
                                             &quantities::limit_amplitude_ratio,
                                             &quantities::stick_ratio};

/// What the runs of each model and point say together, in the order of their first runs. Runs
/// without w and f_T in [0, 1] are left out. The state is that of the finest run; a coarser one in
/// whose state a value tells nothing does not count for it.
std::vector<RollingPoint> rolling_points(const std::vector<RollingRun>& runs);

/// "parallel", "perpendicular" or "30 deg": the direction of the load to the rolling.
std::string direction_name(double angle);
/// The two directions that the thesis has formulas for; at 180 deg the rolling is the same.
bool is_parallel(double angle);
bool is_perpendicular(double angle);

/// An empty Group (a struct with model, group and angle) for each model and group of the points, in
/// their order.
template <class Group>
std::vector<Group> groups_of(const std::vector<RollingPoint>& points) {
    std::vector<Group> groups;
    for (const RollingPoint& p : points)
        if (std::ranges::none_of(
                groups, [&](const Group& g) { return g.model == p.model && g.group == p.group; })) {
            Group& group = groups.emplace_back();
            group.model = p.model;
            group.group = p.group;
            group.angle = p.angle;
        }
    return groups;
}

/// The points of a group.
template <class Group>
std::vector<const RollingPoint*> points_of(const std::vector<RollingPoint>& points,
                                           const Group& group) {
    std::vector<const RollingPoint*> result;
    for (const RollingPoint& p : points)
        if (p.model == group.model && p.group == group.group) result.push_back(&p);
    return result;
}

}  // namespace tricontact::comparisons

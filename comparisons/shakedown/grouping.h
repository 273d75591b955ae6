#pragma once

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <limits>
#include <vector>

#include "comparisons/shakedown/rolling_points.h"

namespace tricontact::comparisons {

/// An empty Group (a struct with model, group and angle) for each model and group of the points, in
/// their order.
template <class Group>
std::vector<Group> groups_of(const std::vector<RollingPoint>& points) {
    std::vector<Group> groups;
    for (const RollingPoint& p : points)
        if (std::none_of(groups.begin(), groups.end(), [&](const Group& g) {
                return g.model == p.model && g.group == p.group;
            })) {
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

/// NaN of none.
inline double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    return boost::math::statistics::median(values);
}

}  // namespace tricontact::comparisons

#include "comparisons/shakedown/rolling_points.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "contact/models/model_kind.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

/// Rolled, or read in an atlas, which has no run that ends.
bool can_be_used(const RollingRun& run) {
    const auto has = [&](const Quantity& q) { return run.results.number(q).has_value(); };
    const auto w = run.results.number(quantities::amplitude_ratio);
    const auto f = run.results.number(quantities::tangential_ratio);
    return w && f && in_unit_range(*w) && in_unit_range(*f) &&
           (has(quantities::final_shift_ratio) || has(quantities::settled_shift_ratio) ||
            has(quantities::shift_increment_ratio));
}

/// Depends on the steps to first order.
bool depends_on_steps(const Quantity& q) {
    return q.told_in == contact::State::ratcheting;
}

/// Runs of one model and point by level and steps, coarse to fine.
using Runs = std::map<std::pair<int, int>, const RollingRun*>;

/// Of the finest steps on each level, or, where they count, extrapolated to steps of no length.
Computed over_levels(const Runs& runs, const Quantity& q) {
    std::map<int, std::map<int, double>> by_level;
    for (const auto& [resolution, run] : runs)
        if (const auto value = run->results.told(q))
            by_level[resolution.first][resolution.second] = *value;
    std::vector<double> sizes, values;
    double step_error = 0;
    for (auto& [level, by_steps] : by_level) {
        Computed value{by_steps.rbegin()->second, 0};
        if (depends_on_steps(q)) {
            by_steps.erase(1);  // turning points alone: too coarse to extrapolate from
            if (by_steps.empty()) continue;
            value = value_of_steps(by_steps);
        }
        sizes.push_back(std::pow(2., -level / 2.));
        values.push_back(value.value);
        step_error = value.error;
    }
    Computed result = value_of_levels(sizes, values);
    result.error += step_error;
    return result;
}

/// Of what was read in an atlas, the bar takes this place, and cells are in it.
void add_error_of_stopping(const Results& results, RollingPoint& p) {
    const double error = results.number(quantities::settled_shift_error_ratio).value_or(NAN);
    const double unit = results.number(quantities::unit_shift).value_or(NAN);
    for (const auto& [q, size] : {std::pair(&quantities::settled_shift_ratio, 1.),
                                  std::pair(&quantities::settled_shift, unit)})
        if (const auto u = p.values.find(q); u != p.values.end())
            u->second.error =
                (contact::model_kind(p.model).is_read() ? 0 : u->second.error) + error * size;
}

RollingPoint point_of(const Runs& runs) {
    const RollingRun& finest = *runs.rbegin()->second;
    const Results& results = finest.results;
    RollingPoint p{.model = finest.model,
                   .group = finest.group,
                   .point = finest.point,
                   .angle = finest.angle,
                   .amplitude_ratio = *results.number(quantities::amplitude_ratio),
                   .tangential_ratio = *results.number(quantities::tangential_ratio),
                   .state = results.state().value_or(contact::State::undecided)};
    for (const Quantity* q : point_quantities) {
        const bool followed = !depends_on_steps(*q) || finest.steps_per_quarter > 1;
        if (results.told(*q) && followed) p.values[q] = over_levels(runs, *q);
    }
    add_error_of_stopping(results, p);
    return p;
}

}  // namespace

bool is_parallel(double angle) {
    return std::abs(std::remainder(angle, std::numbers::pi)) < 1e-9;  // rounding of "180 deg"
}

bool is_perpendicular(double angle) {
    return is_parallel(angle - std::numbers::pi / 2);
}

std::string direction_name(double angle) {
    if (is_parallel(angle)) return "parallel";
    if (is_perpendicular(angle)) return "perpendicular";
    return report::as_given(angle * 180 / std::numbers::pi) + " deg";
}

std::vector<RollingPoint> rolling_points(const std::vector<RollingRun>& runs) {
    std::vector<std::string> order;
    std::map<std::string, Runs> points;
    for (const RollingRun& run : runs) {
        if (!can_be_used(run)) continue;
        const std::string key = run.model + '\n' + run.point;
        if (!points.contains(key)) order.push_back(key);
        points[key][{run.level, run.steps_per_quarter}] = &run;
    }
    std::vector<RollingPoint> result;
    for (const std::string& key : order) result.push_back(point_of(points.at(key)));
    return result;
}

}  // namespace tricontact::comparisons

#include "comparisons/rolling_points.h"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "comparisons/format.h"
#include "comparisons/reference.h"
#include "comparisons/refinement.h"
#include "contact/history.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

/// Shift per period below which it stands still, over U_max; the verdict's own threshold.
constexpr double standing_still = 1e-7;

std::optional<double> value_in(const RollingRun& run, const char* name) {
    const auto found = run.results.find(name);
    return found == run.results.end() || !found->is_number() ? std::nullopt
                                                             : std::optional(found->get<double>());
}

double increment_of(const RollingRun& run) {
    return value_in(run, "shift_increment_ratio").value_or(0);
}

Behaviour behaviour_of(const RollingRun& run) {
    const std::string state = run.results.value("state", json("")).get<std::string>();
    if (state == contact::name_of(contact::State::ratcheting)) return Behaviour::ratcheting;
    if (state == contact::name_of(contact::State::shakedown)) return Behaviour::settled;
    return std::abs(increment_of(run)) <= standing_still ? Behaviour::settled
                                                         : Behaviour::undecided;
}

/// Of a shift that was still settling when the run ended: at least its last change.
double error_of_stopping(const RollingRun& run) {
    const double last = increment_of(run);
    const double way = value_in(run, "final_shift_ratio").value_or(0) -
                       value_in(run, "static_shift_ratio").value_or(0);
    const int n = static_cast<int>(value_in(run, "periods").value_or(1));
    const double to_come = still_to_come(way, last, n);
    // Noise of a shift that stands still does not decay.
    if (std::isinf(to_come) && std::abs(last) <= standing_still) return std::abs(last);
    return std::abs(last) + safety_factor * to_come;
}

bool can_be_used(const RollingRun& run) {
    const auto w = value_in(run, "amplitude_ratio"), f = value_in(run, "tangential_ratio");
    return w && f && in_unit_range(*w) && in_unit_range(*f) && value_in(run, "final_shift_ratio");
}

/// Runs of one model and point, coarse to fine.
class Runs {
  public:
    void add(const RollingRun& run) { runs_[{run.level, run.steps_per_quarter}] = &run; }

    RollingPoint point() const {
        const RollingRun& finest = *runs_.rbegin()->second;
        RollingPoint p{.model = finest.model,
                       .group = finest.group,
                       .point = finest.point,
                       .angle = finest.angle,
                       .amplitude_ratio = *value_in(finest, "amplitude_ratio"),
                       .tangential_ratio = *value_in(finest, "tangential_ratio"),
                       .behaviour = behaviour_of(finest)};
        p.static_shift = over_levels("static_shift_ratio");
        p.limit = over_levels("limit_tangential_ratio");
        if (p.behaviour == Behaviour::settled) {
            p.settled_shift = over_levels("final_shift_ratio", p.behaviour);
            p.settled_shift->error += error_of_stopping(finest);
        }
        if (value_in(finest, "stick_ratio")) p.stick = over_levels("stick_ratio", p.behaviour);
        if (p.behaviour == Behaviour::ratcheting && finest.steps_per_quarter > 1)
            p.increment = over_levels_and_steps("shift_increment_ratio", p.behaviour);
        return p;
    }

  private:
    using Values = std::map<int, double>;  // by steps per quarter

    /// By level; of runs that behave so, if it matters.
    std::map<int, Values> values(const char* name, std::optional<Behaviour> behaviour) const {
        std::map<int, Values> all;
        for (const auto& [resolution, run] : runs_)
            if ((!behaviour || behaviour_of(*run) == *behaviour) && value_in(*run, name))
                all[resolution.first][resolution.second] = *value_in(*run, name);
        return all;
    }

    static Computed of_levels(const std::map<int, double>& values) {
        std::vector<double> sizes, list;
        for (const auto& [level, value] : values) {
            sizes.push_back(std::pow(2., -level / 2.));
            list.push_back(value);
        }
        return value_of_levels(sizes, list);
    }

    Computed over_levels(const char* name, std::optional<Behaviour> behaviour = {}) const {
        std::map<int, double> finest_steps;
        for (const auto& [level, by_steps] : values(name, behaviour))
            finest_steps[level] = by_steps.rbegin()->second;
        return of_levels(finest_steps);
    }

    Computed over_levels_and_steps(const char* name, Behaviour behaviour) const {
        std::map<int, double> extrapolated;
        double step_error = 0;
        for (const auto& [level, by_steps] : values(name, behaviour)) {
            std::vector<int> steps;
            std::vector<double> list;
            for (const auto& [n, value] : by_steps) {
                if (n == 1) continue;  // turning points alone: too coarse to extrapolate from
                steps.push_back(n);
                list.push_back(value);
            }
            if (list.empty()) continue;
            const Computed value = value_of_steps(steps, list);
            extrapolated[level] = value.value;
            step_error = value.error;
        }
        Computed result = of_levels(extrapolated);
        result.error += step_error;
        return result;
    }

    std::map<std::pair<int, int>, const RollingRun*> runs_;  // by level and steps
};

bool is_multiple_of_pi(double angle) {
    return std::abs(std::remainder(angle, std::numbers::pi)) < 1e-9;  // rounding of "180 deg"
}

}  // namespace

bool is_parallel(double angle) {
    return is_multiple_of_pi(angle);
}

bool is_perpendicular(double angle) {
    return is_multiple_of_pi(angle - std::numbers::pi / 2);
}

std::string direction_name(double angle) {
    if (is_parallel(angle)) return "parallel";
    if (is_perpendicular(angle)) return "perpendicular";
    return as_given(angle * 180 / std::numbers::pi) + " deg";
}

std::vector<RollingPoint> rolling_points(const std::vector<RollingRun>& runs) {
    std::vector<std::string> order;
    std::map<std::string, Runs> points;
    for (const RollingRun& run : runs) {
        if (!can_be_used(run)) continue;
        const std::string key = run.model + '\n' + run.point;
        if (!points.contains(key)) order.push_back(key);
        points[key].add(run);
    }
    std::vector<RollingPoint> result;
    for (const std::string& key : order) result.push_back(points.at(key).point());
    return result;
}

}  // namespace tricontact::comparisons

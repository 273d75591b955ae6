#include "comparisons/quantities/friction_loop.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "contact/path_cycles.h"
#include "contact/rig_stiffness.h"

namespace tricontact::comparisons {

namespace {

using contact::History;
using contact::RigStiffness;
using contact::StepRecord;

/// Of the frictional work that would slide the whole contact through the cycle: what rounding of
/// the solvers leaves of none.
constexpr double no_work = 1e-9;

/// Force and shift along one axis.
struct DrivenAxis {
    int d = 0;
    double force(const StepRecord& s) const { return s.tangential_force[d]; }
    double shift(const StepRecord& s) const { return s.shift[d]; }
};

/// Where the line through the steps from `from` to `to` has this force [m].
double shift_at(const std::vector<StepRecord>& steps, std::size_t from, std::size_t to,
                const DrivenAxis& axis, double force) {
    for (std::size_t k = from; k < to; ++k) {
        const double before = axis.force(steps[k]) - force,
                     after = axis.force(steps[k + 1]) - force;
        if (before * after > 0 || before == after) continue;
        return std::lerp(axis.shift(steps[k]), axis.shift(steps[k + 1]), before / (before - after));
    }
    return axis.shift(steps[to]);
}

/// dF/dU after the reversal at step `at` of a branch that goes on to `to`: of the parabola through
/// it and the two steps behind it.
std::optional<double> slope_after(const std::vector<StepRecord>& steps, std::size_t at,
                                  std::size_t to, const DrivenAxis& axis) {
    if (at + 2 > to) return {};
    const auto force = [&](std::size_t k) { return axis.force(steps[k]) - axis.force(steps[at]); };
    const auto shift = [&](std::size_t k) { return axis.shift(steps[k]) - axis.shift(steps[at]); };
    // Compliance over force is as smooth as force over shift, and also exists where forces are
    // prescribed.
    const double f1 = force(at + 1), f2 = force(at + 2);
    if (f1 == 0 || f2 == f1) return {};
    const double compliance = (shift(at + 1) / f1 * f2 - shift(at + 2) / f2 * f1) / (f2 - f1);
    return compliance > 0 ? std::optional(1 / compliance) : std::nullopt;
}

bool all_slips(const StepRecord& step) {
    return step.slip_area > 0 && step.stick_area == 0;
}

SlipRegime regime_of(std::span<const StepRecord> steps, double sliding_work) {
    double work = 0;
    for (const StepRecord& step : steps) work += step.dissipation;
    if (std::ranges::any_of(steps, all_slips)) return SlipRegime::gross_slip;
    return work > no_work * sliding_work ? SlipRegime::partial_slip : SlipRegime::stick;
}

/// Of the branch after the reversal at step `at` that goes on to `to`, see FrictionLoop.
std::optional<double> shift_to_gross_slip(const std::vector<StepRecord>& steps, std::size_t at,
                                          std::size_t to, const DrivenAxis& axis) {
    std::size_t k = at + 1;
    while (k <= to && !all_slips(steps[k])) ++k;
    if (k > to || k < at + 3) return {};
    const StepRecord &before = steps[k - 2], &last = steps[k - 1];
    const double fall = before.stick_area - last.stick_area;
    const double step = axis.shift(steps[k]) - axis.shift(last);
    const double share = fall > 0 && step != 0 ? last.stick_area / fall *
                                                     (axis.shift(last) - axis.shift(before)) / step
                                               : 1;
    return std::abs(axis.shift(last) + std::clamp(share, 0., 1.) * step - axis.shift(steps[at]));
}

FrictionLoop loop_of(const History& history, const RigStiffness& rig, const DrivenAxis& axis,
                     std::size_t begin, std::size_t turn, std::size_t end) {
    const auto& steps = history.steps;
    FrictionLoop loop{.begin = begin, .turn = turn, .end = end};
    const auto within = std::span(steps).subspan(begin, end - begin + 1);
    const auto half_range = [&](const auto& of) {
        const auto [least, most] = std::ranges::minmax(within, {}, of);
        return (of(most) - of(least)) / 2;
    };
    loop.force_amplitude = half_range([&](const StepRecord& s) { return axis.force(s); });
    loop.shift_amplitude = half_range([&](const StepRecord& s) { return axis.shift(s); });
    const auto back = slope_after(steps, begin, turn, axis),
               forth = slope_after(steps, turn, end, axis);
    if (back && forth) loop.tangent_stiffness = (*back + *forth) / 2;
    const double middle = (axis.force(steps[begin]) + axis.force(steps[turn])) / 2;
    loop.aperture = std::abs(shift_at(steps, begin, turn, axis, middle) -
                             shift_at(steps, turn, end, axis, middle));
    for (const StepRecord& step : within) loop.mean_normal_force += step.normal_force;
    loop.mean_normal_force /= static_cast<double>(within.size());
    loop.has_constant_force = half_range([](const StepRecord& s) { return s.normal_force; }) <=
                              1e-9 * loop.mean_normal_force;
    loop.least_stick_area =
        std::ranges::min(within.subspan(1), {}, &StepRecord::stick_area).stick_area;
    const auto one_way = shift_to_gross_slip(steps, begin, turn, axis),
               other_way = shift_to_gross_slip(steps, turn, end, axis);
    if (one_way && other_way) loop.gross_slip_shift = (*one_way + *other_way) / 2;
    if (rig.tangential)
        loop.drive_shift_amplitude =
            half_range([&](const StepRecord& s) { return rig.drive_shift(s)[axis.d]; });
    loop.regime = regime_of(within.subspan(1), 4 * history.friction_limit * loop.shift_amplitude);
    return loop;
}

}  // namespace

const char* name_of(SlipRegime regime) {
    switch (regime) {
        case SlipRegime::stick:
            return "stick";
        case SlipRegime::partial_slip:
            return "partial-slip";
        case SlipRegime::gross_slip:
            return "gross-slip";
        default:
            return "mixed";
    }
}

std::optional<double> FrictionLoop::secant_stiffness() const {
    if (!(shift_amplitude > 0)) return {};
    return force_amplitude / shift_amplitude;
}

std::optional<double> FrictionLoop::sliding_ratio() const {
    if (!(shift_amplitude > 0)) return {};
    return aperture / (2 * shift_amplitude);
}

std::optional<double> FrictionLoop::drive_secant_stiffness() const {
    if (!drive_shift_amplitude || !(*drive_shift_amplitude > 0)) return {};
    return force_amplitude / *drive_shift_amplitude;
}

std::optional<double> FrictionLoop::drive_sliding_ratio() const {
    if (!drive_shift_amplitude || !(*drive_shift_amplitude > 0)) return {};
    return aperture / (2 * *drive_shift_amplitude);
}

std::vector<FrictionLoop> friction_loops(const contact::Case& c, const History& history) {
    if (!c.prescribed_path) return {};
    const auto& rows = c.prescribed_path->rows;
    const auto moves = [&rows](int d) {
        return std::ranges::any_of(rows, [&](const contact::PrescribedPath::Row& row) {
            return row.tangential[d].value != rows.front().tangential[d].value;
        });
    };
    const DrivenAxis axis{moves(0) ? 0 : 1};
    if (!moves(axis.d)) return {};
    const auto at_row = contact::steps_at_rows(history);
    const auto step_at = [&](std::size_t row) {
        return static_cast<std::size_t>(at_row[row] - history.steps.data());
    };
    std::vector<FrictionLoop> loops;
    // Cycles begin behind the first row, the only one that no step may have ended.
    for (const contact::PathCycle& cycle : contact::closed_cycles(*c.prescribed_path))
        if (cycle.end < at_row.size())
            loops.push_back(loop_of(history, c.of<RigStiffness>(), axis, step_at(cycle.begin),
                                    step_at(cycle.turn), step_at(cycle.end)));
    return loops;
}

std::optional<SlipRegime> common_regime(const std::vector<FrictionLoop>& loops) {
    if (loops.empty()) return {};
    return regime_change(loops) ? SlipRegime::mixed : loops.front().regime;
}

std::optional<int> regime_change(const std::vector<FrictionLoop>& loops) {
    const auto found =
        std::ranges::adjacent_find(loops, std::ranges::not_equal_to(), &FrictionLoop::regime);
    if (found == loops.end()) return {};
    return static_cast<int>(found - loops.begin()) + 2;
}

}  // namespace tricontact::comparisons

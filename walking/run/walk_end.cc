#include "walking/run/walk_end.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "walking/machine/velocity_verlet.h"
#include "walking/run/limit_cycle.h"
#include "walking/run/walk_judge.h"
#include "walking/run/walk_recorder.h"

namespace tricontact::walking {

void add_step_error(const Machine& machine, const Motion& motion, double step, WalkResult& result) {
    // The cycles of both steps differ by the order of step^2; ten periods bring one to the other.
    constexpr int settling = 10, averaged = 10;
    const int points = result.section_points;
    const auto enough = static_cast<std::size_t>((settling + averaged) * points + 1);
    VelocityVerlet run(machine, motion, step / 2);
    WalkRecorder recorder(machine, run.motion(), step / 2,
                          std::numeric_limits<std::int64_t>::max());
    const double latest = run.motion().time + 2 * (settling + averaged) * *result.period;
    while (recorder.returns().size() < enough && run.motion().time < latest) {
        run.advance();
        recorder.add(run.motion(), run.spot_steps());
    }
    const std::span<const SectionReturn> all(recorder.returns());
    const auto n = static_cast<std::size_t>(averaged * points + 1);
    if (all.size() < enough) {  // another motion at half the step: nothing is known of the mean
        result.mu_e_error = result.period_error = std::numeric_limits<double>::quiet_NaN();
        return;
    }
    const LimitCycle finer = mean_cycle(machine, all.last(n), points, step / 2);
    const double force = finer.spring_force / sliding_force(machine);
    result.mu_e_error += 4. / 3 * std::abs(force - result.mu_e);
    result.period_error += 4. / 3 * std::abs(finer.period - *result.period);
}

namespace {

/// Phases of the last period but one: the cycle is followed for three more, more densely than
/// pictures need.
std::optional<WalkPhases> find_phases(const WalkCase& walk_case, const Motion& on_cycle,
                                      double period) {
    constexpr double per_period = 2000;
    const double step = walk_case.time.step;
    const auto every =
        std::max(static_cast<std::int64_t>(period / step / per_period), std::int64_t{1});
    const auto n =
        static_cast<std::size_t>(3 * period / step) / static_cast<std::size_t>(every) + 4;
    VelocityVerlet run(walk_case.machine, on_cycle, step);
    SnapshotRecorder snapshots(n, 1);
    for (std::int64_t i = 0; snapshots.first().size() < n; ++i) {
        if (i % every == 0) snapshots.add(run);
        run.advance();
    }
    auto phases = phases_of(walk_case.machine, snapshots.first(), period);
    if (!phases) return phases;
    const double late = phases->turning_point + period - walk_case.time.end;
    phases->shift(-period * std::ceil(late / period));
    return phases;
}

}  // namespace

WalkSteps steps_of(const WalkCase& walk_case, const Recording& recording) {
    const auto& [step, end] = walk_case.time;
    if (!(step > 0) || !(end >= step)) throw std::invalid_argument("a run needs at least one step");
    const auto count = [step = step](double time) {
        return static_cast<std::int64_t>(std::llround(time / step));
    };
    const std::int64_t run = count(end);
    return {.run = run,
            .window = window_steps(run, step),
            .snapshot = std::max(count(recording.interval), std::int64_t{1}),
            .tail = std::min(count(recording.tail), run),
            .judged = std::min(count(judged_time()), run)};
}

std::optional<double> follow(VelocityVerlet& run, std::int64_t n_steps, std::int64_t every,
                             WalkRecorder& recorder, SnapshotRecorder& snapshots) {
    const double limit = tilting_limit(run.machine());
    for (std::int64_t i = 0; i <= n_steps; ++i) {
        if (i % every == 0) snapshots.add(run);
        if (i == n_steps) break;
        run.advance();
        recorder.add(run.motion(), run.spot_steps());
        if (!(std::abs(run.motion().phi) <= limit)) return run.motion().time;
    }
    return std::nullopt;
}

void conclude(const WalkCase& walk_case, const Recording& recording, const Motion& end,
              std::optional<double> tilting_time, const SnapshotRecorder& snapshots, Walk& walk) {
    const Machine& machine = walk_case.machine;
    const double step = walk_case.time.step;
    const WalkSteps steps = steps_of(walk_case, recording);
    walk.result = judge(machine, {step, walk.windows, walk.returns, tilting_time});
    std::int64_t tail = steps.tail / steps.snapshot;
    if (walk.result.period) {
        add_step_error(machine, end, step, walk.result);
        const double interval = static_cast<double>(steps.snapshot) * step;
        // One more, as their length is rounded.
        tail = std::max(tail, std::int64_t{std::llround(3 * *walk.result.period / interval)} + 1);
    }
    walk.start = snapshots.first();
    walk.tail = snapshots.last(static_cast<std::size_t>(tail) + 1);
    judge_drift(machine, walk.periods, walk.result);
    if (walk.result.period) walk.phases = find_phases(walk_case, end, *walk.result.period);
}

}  // namespace tricontact::walking

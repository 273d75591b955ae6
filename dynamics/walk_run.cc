#include "dynamics/walk_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <stdexcept>

#include "dynamics/snapshots.h"
#include "dynamics/step_error.h"
#include "dynamics/velocity_verlet.h"
#include "dynamics/walk_judge.h"
#include "dynamics/walk_recorder.h"

namespace tricontact::dynamics {
namespace {

double processor_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Counts of steps, or of snapshots, in a time.
std::int64_t count(double time, double interval) {
    return static_cast<std::int64_t>(std::llround(time / interval));
}

/// Runs to the end, or until the machine tilts, and fills in what the recorders do not know.
/// Returns the time of tilting.
std::optional<double> run_to_end(const WalkCase& walk_case, const Recording& recording,
                                 WalkRecorder& recorder, LastSnapshots& last, Walk& walk) {
    const auto& [step, end] = walk_case.time;
    const Machine& machine = walk_case.machine;
    const std::int64_t n_steps = count(end, step),
                       stride = std::max(count(recording.interval, step), std::int64_t{1}),
                       start_end = recording.start > 0 ? count(recording.start, step) : -1;
    const double limit = tilting_limit(machine);
    VelocityVerlet run(machine, motion_at_start(machine, walk_case.start), step);
    while (true) {
        if (walk.lane_steps % stride == 0) {
            last.add(run);
            if (walk.lane_steps <= start_end) take_snapshot(run, walk.start.emplace_back());
        }
        if (walk.lane_steps == n_steps) return std::nullopt;
        run.advance();
        ++walk.lane_steps;
        recorder.add(run.motion(), run.spot_steps());
        if (!(std::abs(run.motion().phi) <= limit)) return run.motion().time;
    }
}

}  // namespace

Walk walk(const WalkCase& walk_case, const Recording& recording) {
    const auto& [step, end] = walk_case.time;
    if (!(step > 0) || !(end >= step)) throw std::invalid_argument("a run needs at least one step");
    const double began = processor_time();
    const Machine& machine = walk_case.machine;
    const double interval = std::max(recording.interval, step);
    WalkRecorder recorder(machine, motion_at_start(machine, walk_case.start), step,
                          window_steps(count(end, step), step));
    LastSnapshots last(
        static_cast<std::size_t>(count(std::max(recording.tail, judged_time()), interval)) + 1);
    Walk walk;
    const auto tilting_time = run_to_end(walk_case, recording, recorder, last, walk);

    walk.windows = recorder.windows();
    walk.returns = recorder.returns();
    walk.result = judge(machine, {step, walk.windows, walk.returns, tilting_time});
    double tail = recording.tail;
    if (walk.result.period) {
        add_step_error(machine, walk.returns, step, walk.result);
        // A snapshot more than three periods at either end, for what their length is rounded by.
        tail = std::max(tail, 3 * *walk.result.period + 2 * interval);
    }
    walk.tail = last.last(static_cast<std::size_t>(count(tail, interval)) + 1);
    if (walk.result.period) walk.phases = phases_of(machine, walk.tail, *walk.result.period);
    walk.cpu_s = processor_time() - began;
    return walk;
}

}  // namespace tricontact::dynamics

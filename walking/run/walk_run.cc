#include "walking/run/walk_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "walking/run/lyapunov.h"
#include "walking/run/walk_end.h"

namespace tricontact::walking {
namespace {

double processor_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::size_t n_snapshots(double time, double interval) {
    return time > 0 ? static_cast<std::size_t>(std::llround(time / interval)) + 1 : 0;
}

/// Of what the run goes on to do, for a thousand units of time, or as long as it has taken if that
/// is less; none for a machine that tilts or has hardly begun.
std::optional<statistics::Mean> exponent_at_the_end(const VelocityVerlet& run) {
    Separation separation{.step = run.step()};
    separation.duration = std::min(separation.duration, run.motion().time);
    const bool tilts = std::abs(run.motion().phi) > tilting_limit(run.machine());
    if (tilts || separation.duration < 100) return std::nullopt;
    return lyapunov_exponent(run.machine(), run.motion(), separation);
}

}  // namespace

Walk walk(const WalkCase& walk_case, const Recording& recording) {
    const double began = processor_time(), step = walk_case.time.step;
    const WalkSteps steps = steps_of(walk_case, recording);
    const Machine& machine = walk_case.machine;
    VelocityVerlet run(machine, motion_at_start(machine, walk_case.start), step);
    WalkRecorder recorder(machine, run.motion(), step, steps.window);
    const double interval = static_cast<double>(steps.snapshot) * step;
    const std::int64_t kept = std::max(steps.tail, steps.judged) / steps.snapshot + 1;
    SnapshotRecorder snapshots(n_snapshots(recording.start, interval),
                               static_cast<std::size_t>(kept));
    const auto tilting_time = follow(run, steps.run, steps.snapshot, recorder, snapshots);

    Walk walk;
    walk.windows = recorder.windows();
    walk.returns = recorder.returns();
    walk.periods = recorder.periods();
    walk.last = run.motion();
    for (const WalkWindow& window : walk.windows) walk.lane_steps += window.sums.steps;
    conclude(walk_case, recording, run.motion(), tilting_time, snapshots, walk);
    walk.cpu_s = processor_time() - began;
    walk.result.lyapunov = exponent_at_the_end(run);
    return walk;
}

}  // namespace tricontact::walking

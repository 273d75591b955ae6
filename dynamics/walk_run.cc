#include "dynamics/walk_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <stdexcept>

#include "dynamics/step_error.h"
#include "dynamics/velocity_verlet.h"
#include "dynamics/walk_judge.h"
#include "dynamics/walk_recorder.h"

namespace tricontact::dynamics {
namespace {

SpotState state_of(const SpotDeflection& spot, const SpotStep& step) {
    if (spot.normal == 0) return SpotState::released;
    return step.sticks ? SpotState::stick : SpotState::slip;
}

Snapshot snapshot_of(const VelocityVerlet& run) {
    Snapshot snapshot{run.motion(), {}};
    for (std::size_t i = 0; i < run.spots().size(); ++i)
        snapshot.spots.push_back(state_of(run.motion().spots[i], run.spot_steps()[i]));
    return snapshot;
}

double processor_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

Walk walk(const WalkCase& walk_case, const Recording& recording) {
    const auto& [step, end] = walk_case.time;
    if (!(step > 0) || !(end >= step)) throw std::invalid_argument("a run needs at least one step");
    const double began = processor_time();
    const Machine& machine = walk_case.machine;
    const auto n_steps = static_cast<std::int64_t>(std::llround(end / step));
    const auto steps_in = [step = step](double time) {
        return static_cast<std::int64_t>(std::llround(time / step));
    };
    const std::int64_t start_end = steps_in(recording.start),
                       tail_begin = n_steps - steps_in(recording.tail),
                       stride = std::max(steps_in(recording.interval), std::int64_t{1});
    VelocityVerlet run(machine, motion_at_start(machine, walk_case.start), step);
    WalkRecorder recorder(machine, run.motion(), step, window_steps(n_steps, step));
    std::optional<double> tilting_time;
    Walk result;
    const double limit = tilting_limit(machine);
    for (std::int64_t i = 0; i <= n_steps; ++i) {
        if (i % stride == 0 && i <= start_end) result.start.push_back(snapshot_of(run));
        if (i % stride == 0 && i >= tail_begin) result.tail.push_back(snapshot_of(run));
        if (i == n_steps) break;
        run.advance();
        ++result.lane_steps;
        recorder.add(run.motion(), run.spot_steps());
        if (!(std::abs(run.motion().phi) <= limit)) {
            tilting_time = run.motion().time;
            break;
        }
    }
    result.windows = recorder.windows();
    result.returns = recorder.returns();
    result.result = judge(machine, {step, result.windows, result.returns, tilting_time});
    if (result.result.regime == Regime::limit_cycle)
        add_step_error(machine, result.returns, step, result.result);
    result.cpu_s = processor_time() - began;
    return result;
}

}  // namespace tricontact::dynamics

#include "walking/run/walk_batch.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "walking/kernels/in_parallel.h"
#include "walking/run/walk_end.h"
#include "walking/run/walk_judge.h"

namespace tricontact::walking {
namespace {

/// Motions from which the end of each run is followed again.
struct Ends {
    std::int64_t judged_steps = 0, tail_steps = 0;  ///< before the end
    std::vector<Motion> judged, tail;
};

std::vector<Motion> motions_of(const Batch& batch) {
    std::vector<Motion> motions;
    for (std::size_t i = 0; i < batch.size(); ++i) motions.push_back(batch.motion(i));
    return motions;
}

/// Runs the batch to its end: fills in the windows of the walks.
Ends run_lanes(Batch& batch, const WalkSteps& steps, std::vector<Walk>& walks) {
    // A snapshot more than is wanted: a motion does not tell whether its spots stick.
    Ends ends;
    ends.judged_steps = steps.judged;
    ends.tail_steps = std::min(steps.tail + steps.snapshot, steps.run);
    const std::int64_t judged_begin = steps.run - ends.judged_steps,
                       tail_begin = steps.run - ends.tail_steps;
    std::vector<StretchSums> sums(walks.size());
    const auto time = [&](std::int64_t n) { return static_cast<double>(n) * batch.step(); };
    std::int64_t window_begin = 0, done = 0;
    while (true) {
        if (done == judged_begin) ends.judged = motions_of(batch);
        if (done == tail_begin) ends.tail = motions_of(batch);
        if (done == steps.run) return ends;
        // What is left over lengthens the last window.
        const bool last = steps.run - window_begin < 2 * steps.window;
        const std::int64_t window_end = last ? steps.run : window_begin + steps.window;
        std::int64_t next = window_end;
        for (const std::int64_t stop : {judged_begin, tail_begin})
            if (stop > done) next = std::min(next, stop);
        batch.advance(next - done, Batch::Detail::everything, sums);
        done = next;
        if (done < window_end) continue;
        for (std::size_t i = 0; i < walks.size(); ++i) {
            if (sums[i].steps > 0)  // else it has tilted
                walks[i].windows.push_back(
                    {time(window_begin), time(window_begin + sums[i].steps), sums[i]});
            sums[i] = {};
        }
        window_begin = window_end;
    }
}

/// Follows the end of a run once more, step by step, and judges it.
void conclude_lane(const WalkCase& walk_case, const Recording& recording, const Motion& begin,
                   std::int64_t n_steps, bool tilts, Walk& walk) {
    const WalkSteps steps = steps_of(walk_case, recording);
    VelocityVerlet run(walk_case.machine, begin, walk_case.time.step);
    WalkRecorder recorder(walk_case.machine, begin, walk_case.time.step,
                          std::numeric_limits<std::int64_t>::max());
    SnapshotRecorder snapshots(0, static_cast<std::size_t>(n_steps / steps.snapshot) + 1);
    const auto tilting_time = follow(run, n_steps, steps.snapshot, recorder, snapshots);
    walk.returns = recorder.returns();
    for (const WalkWindow& window : walk.windows) walk.lane_steps += window.sums.steps;
    if (tilts)  // the batch stopped a little before it did
        for (const WalkWindow& window : recorder.windows()) walk.windows.push_back(window);
    conclude(walk_case, recording, run.motion(), tilts ? tilting_time : std::nullopt, snapshots,
             walk);
}

}  // namespace

std::vector<Walk> walk_batch(std::span<const WalkCase> cases, const Recording& recording,
                             const BatchOptions& options) {
    if (cases.empty()) return {};
    const std::clock_t began = std::clock();
    std::vector<Machine> machines;
    std::vector<Motion> starts;
    for (const WalkCase& each : cases) {
        if (!(each.time == cases[0].time))
            throw std::invalid_argument("the cases of a batch have one step and one end");
        machines.push_back(each.machine);
        starts.push_back(motion_at_start(each.machine, each.start));
    }
    const WalkSteps steps = steps_of(cases[0], recording);
    Batch batch(machines, starts, cases[0].time.step, options);
    std::vector<Walk> walks(cases.size());
    const Ends ends = run_lanes(batch, steps, walks);
    in_parallel(cases.size(), options.n_threads, [&](std::size_t i) {
        Walk& walk = walks[i];
        if (batch.tilted(i))
            conclude_lane(cases[i], recording, batch.motion(i), steps.run, true, walk);
        else if (may_repeat(machines[i], walk.windows))
            conclude_lane(cases[i], recording, ends.judged[i], ends.judged_steps, false, walk);
        else
            conclude_lane(cases[i], recording, ends.tail[i], ends.tail_steps, false, walk);
    });
    const double cpu_s = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    for (Walk& walk : walks) walk.cpu_s = cpu_s / static_cast<double>(walks.size());
    return walks;
}

}  // namespace tricontact::walking

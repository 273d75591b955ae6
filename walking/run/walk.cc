#include "walking/run/walk.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "contact/base/interruption.h"
#include "contact/base/special_values.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/run/limit_cycle.h"
#include "walking/run/lyapunov.h"
#include "walking/run/walk_judge.h"
#include "walking/run/walk_recorder.h"

namespace tricontact::walking {

namespace {

/// Numbers of steps that a case and what is to be recorded of it stand for.
struct WalkSteps {
    std::int64_t run = 0;       ///< in the run
    std::int64_t window = 0;    ///< in a window
    std::int64_t snapshot = 0;  ///< between snapshots
    std::int64_t tail = 0;      ///< of the end that is recorded densely
    std::int64_t judged = 0;    ///< of the end in which limit cycles are looked for
    /// Of the end that is followed again where there is none: a snapshot more than is wanted, as a
    /// motion does not tell whether its spots stick.
    std::int64_t followed = 0;
};

/// Throws std::invalid_argument if step or end are not positive.
WalkSteps steps_of(const WalkCase& walk_case, const Recording& recording) {
    const auto& [step, end] = walk_case.time;
    if (!(step > 0) || !(end >= step)) throw std::invalid_argument("a run needs at least one step");
    const auto count = [step = step](double time) {
        return static_cast<std::int64_t>(std::llround(time / step));
    };
    const std::int64_t run = count(end), tail = std::min(count(recording.tail), run),
                       snapshot = std::max(count(recording.interval), std::int64_t{1});
    return {.run = run,
            .window = window_steps(run, step),
            .snapshot = snapshot,
            .tail = tail,
            .judged = std::min(count(judged_time), run),
            .followed = std::min(tail + snapshot, run)};
}

/// Runs on for so many steps, or until the machine tilts; returns the time of that.
std::optional<double> follow(VelocityVerlet& run, std::int64_t n_steps, std::int64_t every,
                             WalkRecorder& recorder, SnapshotRecorder& snapshots,
                             const WalkWatch& watch = {}) {
    constexpr int parts = 1000;
    const double limit = tilting_limit(run.machine());
    const std::int64_t told_every = std::max(n_steps / parts, std::int64_t{1});
    for (std::int64_t i = 0; i <= n_steps; ++i) {
        if (i % every == 0) snapshots.add(run);
        if (watch && i > 0 && i % told_every == 0)
            watch(static_cast<int>(parts * i / n_steps), parts);
        if (i == n_steps) break;
        run.advance();
        recorder.add(run.motion(), run.spot_steps());
        if (!(std::abs(run.motion().phi) <= limit)) return run.motion().time;
    }
    return std::nullopt;
}

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
    SnapshotRecorder snapshots(walk_case.machine, n, 1);
    for (std::int64_t i = 0; snapshots.first().size() < n; ++i) {
        if (i % every == 0) snapshots.add(run);
        run.advance();
    }
    auto phases = phases_of(walk_case.machine, snapshots.first(), period);
    if (!phases) return phases;
    const double late = phases->turning_point + period - walk_case.time.end;
    for (double* each : {&phases->sticking, &phases->turning_point, &phases->release, &phases->jump,
                         &phases->landing})
        *each -= period * std::ceil(late / period);
    return phases;
}

/// What follows from windows and returns: the result, the tail and its phases. `snapshots` are of
/// the last steps_of().judged steps at least, or of the tail where there is no limit cycle; `end`
/// is the motion of the springs there.
void conclude(const WalkCase& walk_case, const WalkSteps& steps, const Motion& end,
              std::optional<double> tilting_time, const SnapshotRecorder& snapshots, Walk& walk) {
    const Machine& machine = walk_case.machine;
    const double step = walk_case.time.step;
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

double processor_time() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
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

/// Motions from which the end of each run is followed again, WalkSteps::judged and ::followed
/// before it.
struct Ends {
    std::vector<Motion> judged, tail;
};

std::vector<Motion> motions_of(const Batch& batch) {
    std::vector<Motion> motions;
    for (std::size_t i = 0; i < batch.size(); ++i) motions.push_back(batch.motion(i));
    return motions;
}

/// Runs the batch to its end: fills in the windows of the walks.
Ends run_lanes(Batch& batch, const WalkSteps& steps, std::vector<Walk>& walks) {
    Ends ends;
    const std::int64_t judged_begin = steps.run - steps.judged,
                       tail_begin = steps.run - steps.followed;
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
        contact::interruption_point();
        batch.advance(next - done, sums);
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
void conclude_lane(const WalkCase& walk_case, const WalkSteps& steps, const Motion& begin,
                   std::int64_t n_steps, bool tilts, Walk& walk) {
    VelocityVerlet run(walk_case.machine, begin, walk_case.time.step);
    WalkRecorder recorder(walk_case.machine, begin, walk_case.time.step,
                          std::numeric_limits<std::int64_t>::max());
    SnapshotRecorder snapshots(walk_case.machine, 0,
                               static_cast<std::size_t>(n_steps / steps.snapshot) + 1);
    const auto tilting_time = follow(run, n_steps, steps.snapshot, recorder, snapshots);
    walk.returns = recorder.returns();
    for (const WalkWindow& window : walk.windows) walk.lane_steps += window.sums.steps;
    if (tilts)  // the batch stopped a little before it did
        for (const WalkWindow& window : recorder.windows()) walk.windows.push_back(window);
    conclude(walk_case, steps, run.motion(), tilts ? tilting_time : std::nullopt, snapshots, walk);
}

}  // namespace

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
        result.mu_e_error = result.period_error = contact::undefined;
        return;
    }
    const LimitCycle finer = mean_cycle(machine, all.last(n), points, step / 2);
    const double force = finer.spring_force / sliding_force(machine);
    result.mu_e_error += 4. / 3 * std::abs(force - result.mu_e);
    result.period_error += 4. / 3 * std::abs(finer.period - *result.period);
}

std::string_view word_of(Regime regime) {
    constexpr std::string_view words[all_regimes.size()] = {
        "steady",   "limit-cycle", "chaotic",    "tilting",
        "sticking", "shakedown",   "ratcheting", "walking"};
    return words[static_cast<int>(regime)];
}

Walk walk(const WalkCase& walk_case, const Recording& recording, const WalkWatch& watch) {
    const double began = processor_time(), step = walk_case.time.step;
    const WalkSteps steps = steps_of(walk_case, recording);
    const Machine& machine = walk_case.machine;
    VelocityVerlet run(machine, motion_at_start(machine, walk_case.start), step);
    WalkRecorder recorder(machine, run.motion(), step, steps.window);
    const double interval = static_cast<double>(steps.snapshot) * step;
    const std::int64_t kept = std::max(steps.tail, steps.judged) / steps.snapshot + 1;
    const double first = recording.start > 0 ? std::round(recording.start / interval) + 1 : 0;
    SnapshotRecorder snapshots(machine, static_cast<std::size_t>(first),
                               static_cast<std::size_t>(kept));
    const auto tilting_time = follow(run, steps.run, steps.snapshot, recorder, snapshots, watch);

    Walk walk;
    walk.windows = recorder.windows();
    walk.returns = recorder.returns();
    walk.periods = recorder.periods();
    walk.last = run.motion();
    for (const WalkWindow& window : walk.windows) walk.lane_steps += window.sums.steps;
    conclude(walk_case, steps, run.motion(), tilting_time, snapshots, walk);
    walk.cpu_s = processor_time() - began;
    walk.result.lyapunov = exponent_at_the_end(run);
    return walk;
}

std::vector<Walk> walk_batch(std::span<const WalkCase> cases, const Recording& recording,
                             Kernel kernel) {
    if (cases.empty()) return {};
    const double began = processor_time();
    std::vector<Machine> machines;
    std::vector<Motion> starts;
    for (const WalkCase& each : cases) {
        if (!(each.time == cases[0].time))
            throw std::invalid_argument("the cases of a batch have one step and one end");
        machines.push_back(each.machine);
        starts.push_back(motion_at_start(each.machine, each.start));
    }
    const WalkSteps steps = steps_of(cases[0], recording);
    Batch batch(machines, starts, cases[0].time.step, kernel);
    std::vector<Walk> walks(cases.size());
    const Ends ends = run_lanes(batch, steps, walks);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        Walk& walk = walks[i];
        if (batch.tilted(i))
            conclude_lane(cases[i], steps, batch.motion(i), steps.run, true, walk);
        else if (may_repeat(machines[i], walk.windows))
            conclude_lane(cases[i], steps, ends.judged[i], steps.judged, false, walk);
        else
            conclude_lane(cases[i], steps, ends.tail[i], steps.followed, false, walk);
    }
    const double cpu_s = processor_time() - began;
    for (Walk& walk : walks) walk.cpu_s = cpu_s / static_cast<double>(walks.size());
    return walks;
}

}  // namespace tricontact::walking

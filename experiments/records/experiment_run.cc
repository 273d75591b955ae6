#include "experiments/records/experiment_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/verdict.h"
#include "experiments/records/drive_delay.h"
#include "experiments/records/record_corrections.h"
#include "experiments/records/record_jumps.h"
#include "experiments/records/record_scales.h"
#include "report/format.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

using contact::State;
using Corrections = RecordCorrections;
using Part = RecordPart;

constexpr double noise_grows = 1.5;  // times that of the rest: it is louder while it rolls

/// Standard error of the slope of the second half by the noise of the record alone [m]; `memory`:
/// only what it has by being correlated from period to period.
double noise_of_slope(const StageEvaluation& stage, const RunEvaluation& run, double interval,
                      bool memory) {
    const std::size_t first = (stage.shift.size() - 1) / 2;
    std::vector<double> count(stage.shift.size() - first);
    std::iota(count.begin(), count.end(), 0.);
    const auto weights = weights_of_slope(count);
    double own = 0, common = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        own += std::pow(weights[i] * stage.noise_error[first + i], 2);
        for (std::size_t k = 0; k < i; ++k)
            common += 2 * weights[i] * weights[k] *
                      run.noise.covariance_at(static_cast<std::size_t>(
                          (stage.time[first + i] - stage.time[first + k]) / interval));
    }
    return std::sqrt(std::max(0., common + (memory ? 0 : own)));
}

void judge(StageEvaluation& stage, const RunEvaluation& run, const Part& samples, double interval,
           double confidence) {
    stage.settling = fit_settling(stage.shift, verdict_confidence);
    const auto half = [&](double level, double error) {
        return run.noise.coverage_factor(level) * error;
    };
    const double noise = noise_of_slope(stage, run, interval, false),
                 drift = run.drift.standard_error * stage.period;
    const auto increment = [&](double level) {
        Estimate e = late_increment(stage.shift, level);
        // Residuals of few values are small by chance, and of noise that remembers: its own error
        // is the least.
        if (const double least = half(level, noise); e.half_width() < least)
            e = {e.value, noise, e.value - least, e.value + least};
        e.widen(drift, half(level, drift));  // an error of the drift is one of the increment
        return e;
    };
    stage.increment = increment(confidence);
    stage.increment_95 = increment(verdict_confidence);
    const double remembered = noise_of_slope(stage, run, interval, true);
    stage.settling.increment.widen(remembered, half(verdict_confidence, remembered));
    stage.settling.increment.widen(drift, half(verdict_confidence, drift));
    stage.curvature = normalised_curvature(stage.time, stage.shift, verdict_confidence);
    stage.sampled_curvature =
        normalised_curvature(samples.time, samples.shift, verdict_confidence).value;
    stage.by_increment =
        judge_increment(stage.settling.increment, stage.periods(), stage.shift.back());
    stage.by_curvature = contact::state_of(stage.curvature.low, stage.curvature.high, 0);
    if (run.is_spoilt()) stage.by_increment = stage.by_curvature = State::undecided;
}

/// Noise that is louder while it rolls is counted as it is there.
void count_louder_noise(RunEvaluation& run, double ratio) {
    if (ratio <= noise_grows) return;
    run.findings.push_back(
        {RecordFinding::Kind::noise,
         fmt::format("the noise is {:.1f} times as large while it rolls as in the rest before, {} "
                     "nm: errors of the values upright are larger by that",
                     ratio, report::significant(1e9 * run.noise.standard_deviation, 3))});
    for (StageEvaluation& stage : run.stages)
        for (std::size_t n = 1; n < stage.shift.size(); ++n) {
            const double more = stage.noise_error[n] * std::sqrt(ratio * ratio - 1);
            stage.noise_error[n] *= ratio;
            stage.shift_error[n] = std::hypot(stage.shift_error[n], more);
        }
}

/// What follows the drive late makes each value upright wrong by as much, but for the first.
void count_delay(RunEvaluation& run, const DriveTimeline::Stage& rolled,
                 const Corrections& corrections) {
    const std::size_t first = rolled.upright.size() / 2;
    if (run.stages.size() > 1 || first + 1 >= rolled.upright.size()) return;
    const Part part = corrections.rest(rolled.upright[first], rolled.upright.back());
    const auto delay = drive_delay(part.time, part.shift, rolled.upright[first],
                                   (rolled.upright.back() - rolled.upright[first]) /
                                       static_cast<double>(rolled.upright.size() - 1 - first));
    if (!delay || !delay->is_seen(rolled.period())) return;
    run.findings.push_back(
        {RecordFinding::Kind::delay,
         fmt::format("what follows the drive is {} it by {} s: the clocks of drive and shift "
                     "differ, or the contact has hysteresis; values upright are uncertain by {} µm",
                     delay->time > 0 ? "behind" : "ahead of",
                     report::with_error(std::abs(delay->time), delay->standard_error, 3),
                     report::significant(1e6 * delay->shift_upright, 2))});
    StageEvaluation& stage = run.stages.front();
    SystematicError timing{"timing of the drive", {0.}};
    for (std::size_t n = 1; n < stage.shift.size(); ++n) {
        timing.of_shift.push_back(delay->shift_upright);
        stage.shift_error[n] = std::hypot(stage.shift_error[n], delay->shift_upright);
    }
    run.systematic.push_back(std::move(timing));
}

void count_drift(RunEvaluation& run, double drifted_zero) {
    if (!run.drift_changes) return;
    run.findings.push_back(
        {RecordFinding::Kind::drift,
         "the drift changes: it is not the same before and after the rolling, or before the load"});
    SystematicError drift{"drift that changes", {}};
    for (const double time : run.stages.front().drift_time)
        drift.of_shift.push_back(std::hypot(run.drift.standard_error * time, drifted_zero));
    run.systematic.push_back(std::move(drift));
}

// What goes with the offset in each period of the second half, beside a straight line in time.
Estimate wobble_of(const DriveTimeline::Stage& stage, const Corrections& corrections,
                   double confidence) {
    std::vector<double> slopes;
    for (std::size_t n = stage.upright.size() / 2; n + 1 < stage.upright.size(); ++n) {
        const Part part = corrections.rest(stage.upright[n], stage.upright[n + 1]);
        std::vector<double> time = part.time;
        for (double& t : time) t -= stage.upright[n];
        const std::vector<double> ones(time.size(), 1.);
        slopes.push_back(
            statistics::fit_linear({ones, time, part.offset}, part.shift).parameters[2].value);
    }
    return statistics::mean_of(slopes, confidence);
}

void check_stages(const Record& record, const Experiment& experiment,
                  const DriveTimeline& timeline) {
    if (experiment.kind != Experiment::Kind::limit && timeline.stages.size() > 1)
        refuse_record(
            record,
            fmt::format("the amplitude changes from {:.4g} mm to {:.4g} mm at {:.4g} s",
                        1e3 * timeline.stages[0].amplitude, 1e3 * timeline.stages[1].amplitude,
                        timeline.stages[1].upright.front()),
            "evaluate amplitudes that rise in steps as kind = \"limit\"");
    for (const auto& stage : timeline.stages)
        if (stage.periods() < fewest_periods)
            refuse_record(
                record,
                fmt::format("there are {} periods from {:.4g} s on, fewer than {}", stage.periods(),
                            stage.upright.front(), fewest_periods),
                "record more periods: fewer do not distinguish a transient from ratcheting");
}

}  // namespace

double RunEvaluation::share_of_rest_after() const {
    if (!after || after->value == before.value) return 0;
    return (drift.value - before.value) / (after->value - before.value);
}

State judge_increment(const Estimate& increment, int periods, double last_shift) {
    return contact::state_of(increment.low, increment.high,
                             negligible_ratcheting * std::abs(last_shift) / periods);
}

State state_by_increment(const std::vector<double>& shift) {
    return judge_increment(fit_settling(shift, verdict_confidence).increment,
                           static_cast<int>(shift.size()) - 1, shift.back());
}

Estimate late_increment(const std::vector<double>& shift, double confidence) {
    const std::size_t first = (shift.size() - 1) / 2;
    const std::vector<double> late(shift.begin() + static_cast<std::ptrdiff_t>(first), shift.end());
    std::vector<double> count(late.size());
    std::iota(count.begin(), count.end(), 0.);
    return fit_polynomial(count, late, 1, confidence).parameters[1];
}

bool RunEvaluation::is_spoilt() const {
    return std::ranges::any_of(findings, &RecordFinding::spoils);
}

bool RunEvaluation::is_comparable() const {
    return !is_spoilt() && std::ranges::none_of(findings, &RecordFinding::hides_amplitude);
}

RunEvaluation evaluate_run(const Record& recorded, const Experiment& experiment) {
    if (recorded.time.size() < fewest_samples)
        refuse_record(recorded, fmt::format("has {} samples", recorded.time.size()),
                      "record a whole run");
    RunEvaluation run;
    Record record = without_outliers(recorded, run.findings);
    DriveTimeline timeline = drive_timeline(record, experiment);
    std::optional<double> loading;
    if (experiment.loading)
        loading = loading_time(record, *experiment.loading, timeline.start()).half_way;
    find_jumps(recorded, timeline, loading, run.findings);
    if (run.is_spoilt() && record.time.size() < recorded.time.size()) {
        // A jump that the rolling undid soon passed for outliers: what was left out was none.
        std::erase_if(run.findings, [](const RecordFinding& finding) {
            return finding.kind == RecordFinding::Kind::outlier;
        });
        record = recorded;
        timeline = drive_timeline(record, experiment);
    }
    find_gaps(record, timeline, run.findings);
    find_uneven_drive(record, timeline, run.findings);
    check_stages(record, experiment, timeline);
    run.name = record.name;
    run.time = record.time;
    run.shift = record.shift;
    Corrections corrections(record, experiment, timeline, run);
    run.loading = corrections.loading();
    for (const auto& known : timeline.stages) {
        StageEvaluation& stage = run.stages.emplace_back();
        stage.amplitude = known.amplitude;
        stage.period = known.period();
        if (run.stages.size() == 1)
            corrections.add_static(stage);
        else
            corrections.add_upright(stage, known.upright.front(), stage.period);
        for (std::size_t n = 1; n < known.upright.size(); ++n)
            corrections.add_upright(stage, known.upright[n], stage.period);
    }
    find_sign(record, run.stages.front().shift.front(), run.stages.front().shift_error.front(),
              run.findings);
    count_louder_noise(run, corrections.noise_ratio());
    count_delay(run, timeline.stages.front(), corrections);
    count_drift(run, corrections.drifted_zero());
    for (std::size_t k = 0; k < run.stages.size(); ++k) {
        const auto& upright = timeline.stages[k].upright;
        judge(run.stages[k], run, corrections.rest(upright.front(), upright.back()),
              corrections.mean_interval(), experiment.confidence);
    }
    if (run.stages.size() == 1 && run.stages[0].amplitude > 0)
        run.wobble = wobble_of(timeline.stages[0], corrections, experiment.confidence);
    return run;
}

}  // namespace tricontact::experiments

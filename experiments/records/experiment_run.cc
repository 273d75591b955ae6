#include "experiments/records/experiment_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/verdict.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

using contact::State;

constexpr double window = 1. / 16;   // of a period, to both sides of the upright roller
constexpr double drifts_differ = 3;  // standard errors

/// Successive samples.
struct Part {
    std::vector<double> time, shift, offset;
};

std::vector<double> mean_weights(std::size_t n) {
    return std::vector<double>(n, 1 / static_cast<double>(n));
}

RecordNoise noise_of(const Part& rest, double resolution) {
    const double slope = weighted(weights_of_slope(rest.time), rest.shift);
    const double first =
        weighted(weights_of_polynomial_at(rest.time.front(), rest.time, 1), rest.shift);
    std::vector<double> residuals;
    for (std::size_t i = 0; i < rest.time.size(); ++i)
        residuals.push_back(rest.shift[i] - first - slope * (rest.time[i] - rest.time.front()));
    return {residuals, resolution};
}

Estimate drift_of(const Part& rest, const RecordNoise& noise) {
    const auto weights = weights_of_slope(rest.time);
    return {weighted(weights, rest.shift), noise.standard_error(weights)};
}

// Mean of the drifts before and after by their errors; where they contradict each other, the error
// grows with their difference (Birge's ratio).
void settle_drift(RunEvaluation& run) {
    run.drift = run.before;
    if (!run.after) return;
    const double vb = run.before.standard_error * run.before.standard_error;
    const double va = run.after->standard_error * run.after->standard_error;
    const double difference = run.after->value - run.before.value;
    if (va + vb == 0) {
        run.drift = {run.before.value + difference / 2, std::abs(difference) / 2};
        return;
    }
    const double ratio = std::abs(difference) / std::sqrt(va + vb);
    run.drift.value = run.before.value + difference * vb / (va + vb);
    run.drift.standard_error = std::sqrt(va * vb / (va + vb)) * std::max(1., ratio);
    run.drift_changes = ratio > drifts_differ;
}

/// Noise, drift and zero of a record, found in its rests.
class Corrections {
  public:
    Corrections(const Record& record, const Experiment& experiment, const DriveTimeline& timeline,
                RunEvaluation& run)
        : record_(record), timeline_(timeline), run_(run) {
        const double first = record.time.front();
        loading_ = experiment.loading.value_or(first);
        reference_ = timeline.start();
        run.rest = timeline.start() - loading_;
        run.rest_is_whole = experiment.loading.has_value();
        // A load that was applied in the record has the first half of the rest to settle.
        const double from = experiment.loading ? (loading_ + timeline.start()) / 2 : first;
        rest_ = rest(from, timeline.start());
        if (rest_.time.size() < fewest_rest_samples)
            refuse_record(record,
                          fmt::format("there are {} samples of rest under load before rolling "
                                      "begins at {:.4g} s, fewer than {}",
                                      rest_.time.size(), timeline.start(), fewest_rest_samples),
                          "record the static shift longer");
        run.noise = noise_of(rest_, experiment.resolution.value_or(smallest_step(record.shift)));
        run.degrees_of_freedom =
            std::max(1, static_cast<int>(static_cast<double>(rest_.time.size()) /
                                         run.noise.correlated_samples()) -
                            2);
        run.before = drift_of(rest_, run.noise);
        const double end = timeline.end() + stopping * timeline.stages.back().period();
        const Part after = rest(end, record.time.back());
        if (after.time.size() >= fewest_rest_samples) run.after = drift_of(after, run.noise);
        settle_drift(run);
        for (std::size_t i = 0; i < run.time.size(); ++i)
            run.shift[i] -= run.drift.value * (run.time[i] - timeline.start());
        if (experiment.loading) subtract_zero(first);
        rest_ = rest(from, timeline.start());
    }

    /// Before the first period.
    void add_static(StageEvaluation& stage) const {
        add(stage, timeline_.start(), rest_, mean_weights(rest_.time.size()));
    }

    /// Near an instant with the roller upright: the value at offset 0 of the parabola over the
    /// offset, free of what the table adds in proportion to it, and of what the contact adds to
    /// both sides alike.
    void add_upright(StageEvaluation& stage, double upright, double period) const {
        const Part part = rest(upright - window * period, upright + window * period);
        add(stage, upright, part, weights_of_polynomial_at(0, part.offset, 2));
    }

    Part rest(double from, double to) const {
        Part part;
        const auto begin = std::ranges::lower_bound(run_.time, from) - run_.time.begin();
        const auto end = std::ranges::upper_bound(run_.time, to) - run_.time.begin();
        if (end <= begin) return part;
        part.time.assign(run_.time.begin() + begin, run_.time.begin() + end);
        part.shift.assign(run_.shift.begin() + begin, run_.shift.begin() + end);
        part.offset.assign(timeline_.offset.begin() + begin, timeline_.offset.begin() + end);
        return part;
    }

  private:
    void subtract_zero(double first) {
        const Part unloaded = rest(first, loading_);
        if (unloaded.time.size() < 3)
            refuse_record(record_, "there are fewer than 3 samples before record.loading",
                          "omit loading if the record begins later");
        const auto weights = mean_weights(unloaded.time.size());
        const double zero = weighted(weights, unloaded.shift);
        zero_error_ = run_.noise.standard_error(weights);
        reference_ = weighted(weights, unloaded.time);
        for (double& u : run_.shift) u -= zero;
    }
    void add(StageEvaluation& stage, double at, const Part& part,
             const std::vector<double>& weights) const {
        stage.time.push_back(at);
        stage.shift.push_back(weighted(weights, part.shift));
        stage.noise_error.push_back(run_.noise.standard_error(weights));
        stage.drift_time.push_back(weighted(weights, part.time) - reference_);
        stage.shift_error.push_back(std::hypot(stage.noise_error.back(),
                                               run_.drift.standard_error * stage.drift_time.back(),
                                               zero_error_));
    }

    const Record& record_;
    const DriveTimeline& timeline_;
    RunEvaluation& run_;
    Part rest_;
    double loading_ = 0, zero_error_ = 0;
    double reference_ = 0;  // where the drift has no error [s]
};

void judge(StageEvaluation& stage, const RunEvaluation& run, const Part& samples,
           double confidence) {
    stage.settling = fit_settling(stage.shift, verdict_confidence);
    stage.increment = late_increment(stage.shift, confidence);
    // An error of the drift is one of the walk.
    const double drift = run.drift.standard_error * stage.period;
    const auto half = [&](double level) {
        return statistics::student_t(level, run.degrees_of_freedom) * drift;
    };
    stage.settling.increment.widen(drift, half(verdict_confidence));
    stage.increment.widen(drift, half(confidence));
    stage.curvature = normalised_curvature(stage.time, stage.shift, verdict_confidence);
    stage.sampled_curvature =
        normalised_curvature(samples.time, samples.shift, verdict_confidence).value;
    stage.by_walk = judge_walk(stage.settling.increment, stage.periods(), stage.shift.back());
    stage.by_curvature = contact::state_of(stage.curvature.low, stage.curvature.high, 0);
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

State judge_walk(const Estimate& increment, int periods, double last_shift) {
    return contact::state_of(increment.low, increment.high,
                             negligible_walk * std::abs(last_shift) / periods);
}

State state_by_walk(const std::vector<double>& shift) {
    return judge_walk(fit_settling(shift, verdict_confidence).increment,
                      static_cast<int>(shift.size()) - 1, shift.back());
}

Estimate late_increment(const std::vector<double>& shift, double confidence) {
    const std::size_t first = (shift.size() - 1) / 2;
    const std::vector<double> late(shift.begin() + static_cast<std::ptrdiff_t>(first), shift.end());
    std::vector<double> count(late.size());
    std::iota(count.begin(), count.end(), 0.);
    return fit_polynomial(count, late, 1, confidence).parameters[1];
}

RunEvaluation evaluate_run(const Record& record, const Experiment& experiment) {
    if (record.time.size() < fewest_samples)
        refuse_record(record, fmt::format("has {} samples", record.time.size()),
                      "record a whole run");
    const DriveTimeline timeline = drive_timeline(record, experiment);
    check_stages(record, experiment, timeline);
    RunEvaluation run;
    run.name = record.name;
    run.time = record.time;
    run.shift = record.shift;
    const Corrections corrections(record, experiment, timeline, run);
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
        judge(stage, run, corrections.rest(known.upright.front(), known.upright.back()),
              experiment.confidence);
    }
    if (run.stages.size() == 1 && run.stages[0].amplitude > 0)
        run.wobble = wobble_of(timeline.stages[0], corrections, experiment.confidence);
    return run;
}

}  // namespace tricontact::experiments

#include "experiments/records/record_corrections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/records/record_hum.h"
#include "experiments/records/record_scales.h"
#include "statistics/regression.h"

namespace tricontact::experiments {

namespace {

constexpr double window = upright_window;
constexpr double drifts_differ = 3;        // standard errors
constexpr double fewest_independent = 10;  // values of the rest that tell its noise

using Part = RecordPart;

std::vector<double> mean_weights(std::size_t n) {
    return std::vector<double>(n, 1 / static_cast<double>(n));
}

/// About a straight line.
std::vector<double> residuals_of(const Part& rest) {
    const double slope = weighted(weights_of_slope(rest.time), rest.shift);
    const double first =
        weighted(weights_of_polynomial_at(rest.time.front(), rest.time, 1), rest.shift);
    std::vector<double> residuals;
    for (std::size_t i = 0; i < rest.time.size(); ++i)
        residuals.push_back(rest.shift[i] - first - slope * (rest.time[i] - rest.time.front()));
    return residuals;
}

Estimate drift_of(const Part& rest, const RecordNoise& noise) {
    const auto weights = weights_of_slope(rest.time);
    return {weighted(weights, rest.shift), noise.standard_error(weights)};
}

// Mean of the drifts before and after by their errors, which grow with their difference (Birge's
// ratio). Where they contradict each other the drift changes while it rolls, at a rate between
// both: the plain mean, and half their difference, whatever their own errors are.
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
    if (run.drift_changes)
        run.drift = {run.before.value + difference / 2, std::abs(difference) / 2};
}

// Without a rest after the rolling the drift's change shows in the rest before it alone: what it
// does afterwards is known no better than by that change.
void compare_halves(RunEvaluation& run, const Part& rest) {
    if (run.after || rest.time.size() < 2 * fewest_rest_samples) return;
    const auto middle = static_cast<std::ptrdiff_t>(rest.time.size() / 2);
    const Part early{{rest.time.begin(), rest.time.begin() + middle},
                     {rest.shift.begin(), rest.shift.begin() + middle},
                     {}};
    const Part late{{rest.time.begin() + middle, rest.time.end()},
                    {rest.shift.begin() + middle, rest.shift.end()},
                    {}};
    const Estimate before = drift_of(early, run.noise), after = drift_of(late, run.noise);
    const double difference = std::abs(after.value - before.value);
    if (difference <= drifts_differ * std::hypot(before.standard_error, after.standard_error))
        return;
    run.drift_changes = true;
    run.drift.standard_error = std::hypot(run.drift.standard_error, difference);
}

}  // namespace

RecordCorrections::RecordCorrections(const Record& record, const Experiment& experiment,
                                     const DriveTimeline& timeline, RunEvaluation& run)
    : record_(record), timeline_(timeline), run_(run) {
    const double first = record.time.front();
    std::optional<LoadingTime> loading;
    if (experiment.loading) loading = found_loading(*experiment.loading);
    loading_ = loading ? loading->time : first;
    reference_ = timeline.start();
    run.rest = timeline.start() - loading_;
    run.rest_is_whole = loading.has_value();
    find_repeated_values(record, timeline, loading_, run.findings);
    // A load that was applied in the record has the first half of the rest to settle.
    const double from = loading ? (loading_ + timeline.start()) / 2 : first;
    rest_ = rest(from, timeline.start());
    if (rest_.time.size() < fewest_rest_samples)
        refuse_record(record,
                      fmt::format("there are {} samples of rest under load before rolling "
                                  "begins at {:.4g} s, fewer than {}",
                                  rest_.time.size(), timeline.start(), fewest_rest_samples),
                      "record the static shift longer");
    know_noise(resolution_of(record, experiment.resolution, run.findings));
    run.before = drift_of(rest_, run.noise);
    const double end = timeline.end() + stopping * timeline.stages.back().period();
    const Part after = rest(end, record.time.back());
    if (after.time.size() >= fewest_rest_samples) run.after = drift_of(after, run.noise);
    settle_drift(run);
    compare_halves(run, rest_);
    for (std::size_t i = 0; i < run.time.size(); ++i)
        run.shift[i] -= run.drift.value * (run.time[i] - timeline.start());
    if (loading) subtract_zero(loading->n_unloaded);
    rest_ = rest(from, timeline.start());
}

double RecordCorrections::mean_interval() const {
    return (rest_.time.back() - rest_.time.front()) / static_cast<double>(rest_.time.size() - 1);
}

void RecordCorrections::add_static(StageEvaluation& stage) const {
    const auto weights = mean_weights(rest_.time.size());
    add(stage, timeline_.start(), rest_, weights);
    if (!run_.drift_changes) return;
    // The rest has a slope of its own beside the mean drift: its value is that at its end.
    const double lever = timeline_.start() - weighted(weights, rest_.time);
    stage.shift.back() += (run_.before.value - run_.drift.value) * lever;
    stage.drift_time.back() = timeline_.start() - reference_;
    stage.shift_error.back() =
        std::hypot(std::hypot(stage.noise_error.back(), run_.before.standard_error * lever),
                   run_.drift.standard_error * stage.drift_time.back(), zero_error_);
}

void RecordCorrections::add_upright(StageEvaluation& stage, double upright, double period) {
    const Part part = rest(upright - window * period, upright + window * period);
    if (part.time.empty())
        refuse_record(
            record_, fmt::format("there is no sample with the roller upright at {:.4g} s", upright),
            "leave this run out, or cut the record before");
    add(stage, upright, part, weights_of_polynomial_at(0, part.offset, 2));
    add_residuals(part);
}

double RecordCorrections::noise_ratio() const {
    const double at_rest =
        std::hypot(run_.noise.standard_deviation, run_.noise.resolution / std::sqrt(12.));
    if (freedom_ == 0 || at_rest == 0) return 1;
    return std::sqrt(squares_ / freedom_) / at_rest;
}

Part RecordCorrections::rest(double from, double to) const {
    Part part;
    const auto begin = std::ranges::lower_bound(run_.time, from) - run_.time.begin();
    const auto end = std::ranges::upper_bound(run_.time, to) - run_.time.begin();
    if (end <= begin) return part;
    part.time.assign(run_.time.begin() + begin, run_.time.begin() + end);
    part.shift.assign(run_.shift.begin() + begin, run_.shift.begin() + end);
    part.offset.assign(timeline_.offset.begin() + begin, timeline_.offset.begin() + end);
    return part;
}

LoadingTime RecordCorrections::found_loading(double stated) {
    const LoadingTime found = loading_time(record_, stated, timeline_.start());
    if (found.time != stated)
        run_.findings.push_back(
            {RecordFinding::Kind::loading,
             fmt::format("record.loading is {:.4g} s, but the shift rises at {:.4g} s: the "
                         "record counts",
                         stated, found.time)});
    return found;
}

void RecordCorrections::know_noise(double resolution) {
    const std::vector<double> residuals = residuals_of(rest_);
    run_.noise = {residuals, resolution};
    find_hum(residuals, mean_interval(), resolution, run_.findings);
    const double independent =
        static_cast<double>(rest_.time.size()) / run_.noise.correlated_samples;
    run_.degrees_of_freedom =
        std::max(1, std::min(static_cast<int>(independent) - 2, run_.noise.degrees_of_freedom));
    constexpr double rounding = 1e-8;  // of the shift: no noise, but digits of a computed record
    const double size = std::abs(weighted(mean_weights(rest_.shift.size()), rest_.shift));
    if (independent >= fewest_independent || run_.noise.standard_deviation <= rounding * size)
        return;
    run_.findings.push_back(
        {RecordFinding::Kind::correlation,
         fmt::format("the noise is correlated over {:.2g} s: the rest before rolling, {:.3g} s, "
                     "holds {:.1f} independent values, from which its error is poorly known; "
                     "record a longer rest",
                     run_.noise.correlated_samples * mean_interval(),
                     rest_.time.back() - rest_.time.front(), independent)});
}

void RecordCorrections::subtract_zero(std::size_t n_unloaded) {
    const auto n = static_cast<std::ptrdiff_t>(n_unloaded);
    const Part unloaded{{run_.time.begin(), run_.time.begin() + n},
                        {run_.shift.begin(), run_.shift.begin() + n},
                        {}};
    const auto weights = mean_weights(n_unloaded);
    const double zero = weighted(weights, unloaded.shift);
    zero_error_ = run_.noise.standard_error(weights);
    reference_ = weighted(weights, unloaded.time);
    for (double& u : run_.shift) u -= zero;
    if (n_unloaded < fewest_rest_samples) return;
    // What is left of the drift there, of the mean drift.
    const Estimate left = drift_of(unloaded, run_.noise);
    if (std::abs(left.value) <
        drifts_differ * std::hypot(left.standard_error, run_.drift.standard_error))
        return;
    drifted_zero_ = std::abs(left.value) * (timeline_.start() - reference_);
    zero_error_ = std::hypot(zero_error_, drifted_zero_);
    run_.drift_changes = true;
}
void RecordCorrections::add(StageEvaluation& stage, double at, const Part& part,
                            const std::vector<double>& weights) const {
    stage.time.push_back(at);
    stage.shift.push_back(weighted(weights, part.shift));
    stage.noise_error.push_back(run_.noise.standard_error(weights));
    stage.drift_time.push_back(weighted(weights, part.time) - reference_);
    stage.shift_error.push_back(std::hypot(stage.noise_error.back(),
                                           run_.drift.standard_error * stage.drift_time.back(),
                                           zero_error_));
}

void RecordCorrections::add_residuals(const Part& part) {
    constexpr std::size_t parameters = 3;
    const auto [low, high] = std::ranges::minmax(part.offset);
    if (part.time.size() <= parameters + 1 || low == high) return;
    std::vector<double> ones(part.time.size(), 1.), square;
    // At the end of the rolling the offset stands: a line has all that there is.
    std::vector<double> distinct = part.offset;
    std::ranges::sort(distinct);
    distinct.erase(std::ranges::unique(distinct).begin(), distinct.end());
    if (distinct.size() <= parameters) return;
    const double scale = std::max(std::abs(low), std::abs(high));
    std::vector<double> offset = part.offset;
    for (double& w : offset) {
        w /= scale;
        square.push_back(w * w);
    }
    const auto fit = statistics::fit_linear({ones, offset, square}, part.shift);
    squares_ += fit.residual_sum_of_squares;
    freedom_ += fit.degrees_of_freedom;
}

}  // namespace tricontact::experiments

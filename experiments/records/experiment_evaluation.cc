#include "experiments/records/experiment_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/error.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using contact::State;

constexpr double equal_amplitudes = 0.02;  // of repeats, relative
constexpr int many = 1'000'000;            // degrees of freedom of a known standard error

// Of one run, by noise and drift.
Estimate value_at(const RunEvaluation& run, std::size_t n, double confidence) {
    const StageEvaluation& stage = run.stages.front();
    return statistics::with_interval(stage.shift[n], stage.shift_error[n],
                                     statistics::student_t(confidence, run.degrees_of_freedom));
}

// The zero's error is the same in both values, the drift's differs by that of one period.
Estimate increment_at(const RunEvaluation& run, std::size_t n, double confidence) {
    const StageEvaluation& stage = run.stages.front();
    const double drift = run.drift.standard_error * (stage.drift_time[n] - stage.drift_time[n - 1]);
    const double error =
        std::hypot(std::hypot(stage.noise_error[n], stage.noise_error[n - 1]), drift);
    return statistics::with_interval(stage.shift[n] - stage.shift[n - 1], error,
                                     statistics::student_t(confidence, run.degrees_of_freedom));
}

State joint_state(const std::vector<RunEvaluation>& runs) {
    State joint = State::undecided;
    for (const RunEvaluation& run : runs) {
        const State state = run.stages.front().by_walk;
        if (state == State::undecided) continue;
        if (joint != State::undecided && joint != state) return State::undecided;
        joint = state;
    }
    return joint;
}

void check_amplitudes(const std::vector<RunEvaluation>& runs) {
    const double first = runs.front().stages.front().amplitude;
    for (const RunEvaluation& run : runs) {
        const double other = run.stages.front().amplitude;
        if (std::abs(other - first) > equal_amplitudes * first)
            throw contact::InputError(fmt::format(
                "{}: the amplitude is {:.4g} mm, but {:.4g} mm in {}; repeats are runs under equal "
                "conditions: evaluate others apart",
                run.name, 1e3 * other, 1e3 * first, runs.front().name));
    }
}

void put_together(ExperimentEvaluation& e) {
    const auto over_runs = [&](auto&& of_run) {
        std::vector<Estimate> of_runs;
        for (const RunEvaluation& run : e.runs) of_runs.push_back(of_run(run));
        return repeated(of_runs, e.confidence);
    };
    const auto last = static_cast<std::size_t>(e.periods);
    for (std::size_t n = 0; n <= last; ++n) {
        const auto shift = over_runs([&](auto& run) { return value_at(run, n, e.confidence); });
        e.shift.push_back(shift.at_confidence);
        if (n == 0) e.static_shift = shift;
        if (n == last) e.final_shift = shift;
    }
    for (std::size_t n = 1; n <= last; ++n)
        e.period_increments.push_back(
            over_runs([&](auto& run) { return increment_at(run, n, e.confidence); }).at_confidence);
    std::vector<Estimate> wobble;
    for (const RunEvaluation& run : e.runs)
        if (run.wobble) wobble.push_back(*run.wobble);
    if (!wobble.empty()) e.wobble = repeated(wobble, e.confidence);
    e.settled_shift = over_runs([](auto& run) { return run.stages.front().settling.settled; });
    e.increment = over_runs([](auto& run) { return run.stages.front().increment; });
}

void read_limits(ExperimentEvaluation& e) {
    std::vector<Estimate> middle, low, shift;
    for (const RunEvaluation& run : e.runs) {
        e.limits_by_curvature.push_back(
            read_limit(run, &StageEvaluation::by_curvature, e.confidence));
        const auto limit =
            e.limits.emplace_back(read_limit(run, &StageEvaluation::by_walk, e.confidence));
        if (!limit) continue;
        const double half = (limit->amplitude_high - limit->amplitude_low) / 2;
        const double mean = limit->amplitude_low + half;
        // Anywhere between the stages with equal probability: half width over sqrt(3).
        middle.push_back({mean, half / std::sqrt(3.), mean - half, mean + half});
        low.push_back({limit->amplitude_low, 0, limit->amplitude_low, limit->amplitude_low});
        shift.push_back(limit->lines.shift);
    }
    if (middle.empty()) return;
    e.limit_amplitude = repeated(middle, e.confidence);
    e.last_shakedown = repeated(low, e.confidence);
    e.limit_shift = repeated(shift, e.confidence);
    if (middle.size() == 1) {
        e.limit_amplitude->at_95 = e.limit_amplitude->at_confidence;
        return;
    }
    // The steps of the amplitude; and how far from straight the shift is in both stages.
    for (Estimate* w : {&e.limit_amplitude->at_confidence, &e.limit_amplitude->at_95})
        w->widen(middle.front().standard_error, middle.front().half_width());
    for (Estimate* u : {&e.limit_shift->at_confidence, &e.limit_shift->at_95})
        u->widen(shift.front().standard_error, shift.front().half_width());
}

}  // namespace

std::optional<bool> Deviation::differs() const {
    if (!has_errors || rest_is_missing) return {};
    Estimate with_creep = measured;
    (creep > 0 ? with_creep.high : with_creep.low) += creep;
    if (differ(with_creep, predicted)) return true;
    if (differ(measured, predicted)) return {};
    return false;
}

Repeated repeated(const std::vector<Estimate>& of_runs, double confidence) {
    Repeated r;
    r.runs = static_cast<int>(of_runs.size());
    if (of_runs.size() == 1) {
        const Estimate& only = of_runs.front();
        const double t =
            statistics::student_t(0.95, many) / statistics::student_t(confidence, many);
        r.at_confidence = only;
        r.at_95 = {only.value, only.standard_error, only.value - t * (only.value - only.low),
                   only.value + t * (only.high - only.value)};
        return r;
    }
    std::vector<double> values;
    for (const Estimate& e : of_runs) values.push_back(e.value);
    r.at_confidence = statistics::mean_of(values, confidence);
    r.at_95 = statistics::mean_of(values, 0.95);
    return r;
}

ExperimentEvaluation evaluate_experiment(const Experiment& experiment) {
    ExperimentEvaluation e;
    e.kind = experiment.kind;
    e.title = experiment.title;
    e.confidence = experiment.confidence;
    for (const auto& record : experiment.records)
        e.runs.push_back(evaluate_run(record, experiment));
    check_amplitudes(e.runs);
    e.state = joint_state(e.runs);
    e.periods = e.runs.front().stages.front().periods();
    for (const RunEvaluation& run : e.runs) {
        e.periods = std::min(e.periods, run.stages.front().periods());
        e.amplitude += run.stages.front().amplitude / static_cast<double>(e.runs.size());
        e.rest.time += run.rest / static_cast<double>(e.runs.size());
        e.rest.is_whole = run.rest_is_whole;
    }
    put_together(e);
    if (e.kind == Experiment::Kind::limit) read_limits(e);
    return e;
}

void add_prediction(ExperimentEvaluation& e, ModelPrediction prediction) {
    const double n = e.periods;
    const auto add = [&](const char* name, const Repeated& measured, double n_drifted, auto&& of) {
        const double value = of(prediction.shift);
        double variance = 0;
        for (const auto& raised : prediction.raised) {
            const double change = of(raised) - value;
            variance += change * change;
        }
        Deviation d{prediction.model, name, measured.at_confidence,
                    statistics::with_interval(value, std::sqrt(variance),
                                              statistics::student_t(e.confidence, many))};
        d.has_errors = !prediction.raised.empty();
        if (e.rolled_as.hold) {
            d.rest_is_missing = !e.rolled_as.hold_is_known;
            double drifted = 0;  // in one period
            for (const auto& run : e.runs) drifted += run.drift.value * run.stages[0].period;
            d.creep = n_drifted * (drifted / static_cast<double>(e.runs.size()));
        }
        e.deviations.push_back(std::move(d));
    };
    add("u_stat", e.static_shift, 0, [](const std::vector<double>& u) { return u.front(); });
    if (e.kind == Experiment::Kind::shakedown)
        add("u_sd", e.final_shift, n, [](const std::vector<double>& u) { return u.back(); });
    else
        add("Du", e.increment, 1,
            [&](const std::vector<double>& u) { return late_increment(u, e.confidence).value; });
    e.predictions.push_back(std::move(prediction));
}

}  // namespace tricontact::experiments

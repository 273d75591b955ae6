#include "experiments/records/experiment_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
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
                                     run.noise.coverage_factor(confidence));
}

// The zero's error is the same in both values, the drift's differs by that of one period.
Estimate increment_at(const RunEvaluation& run, std::size_t n, double confidence) {
    const StageEvaluation& stage = run.stages.front();
    const double drift = run.drift.standard_error * (stage.drift_time[n] - stage.drift_time[n - 1]);
    const double error =
        std::hypot(std::hypot(stage.noise_error[n], stage.noise_error[n - 1]), drift);
    return statistics::with_interval(stage.shift[n] - stage.shift[n - 1], error,
                                     run.noise.coverage_factor(confidence));
}

State joint_state(const std::vector<RunEvaluation>& runs) {
    State joint = State::undecided;
    for (const RunEvaluation& run : runs) {
        const State state = run.stages.front().by_increment;
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

// Root of the sum of squares of what the kinds are to a value.
template <class Of>
double systematic(const std::vector<SystematicError>& errors, const Of& of) {
    double squares = 0;
    for (const SystematicError& one : errors) squares += std::pow(of(one.of_shift), 2);
    return std::sqrt(squares);
}

void widen(Repeated& r, double error, double confidence) {
    if (error == 0) return;
    r.systematic = error;
    r.at_confidence.widen(error, statistics::normal_quantile(confidence) * error);
    r.at_95.widen(error, statistics::normal_quantile(.95) * error);
}

void put_together(ExperimentEvaluation& e) {
    const auto errors = common_errors(e);
    // `of_run`: with its interval of a level; `of_error`: what is in the value of errors of shifts.
    const auto over_runs = [&](auto&& of_run, auto&& of_error) {
        std::vector<Estimate> of_runs;
        for (const RunEvaluation& run : e.runs) of_runs.push_back(of_run(run, e.confidence));
        Repeated r = repeated(of_runs, e.confidence);
        if (r.runs == 1) r.at_95 = of_run(e.runs.front(), .95);
        widen(r, systematic(errors, of_error), e.confidence);
        return r;
    };
    const auto last = static_cast<std::size_t>(e.periods);
    for (std::size_t n = 0; n <= last; ++n) {
        const auto shift =
            over_runs([&](auto& run, double level) { return value_at(run, n, level); },
                      [&](auto& error) { return error[n]; });
        e.shift.push_back(shift.at_confidence);
        if (n == 0) e.static_shift = shift;
        if (n == last) e.final_shift = shift;
    }
    for (std::size_t n = 1; n <= last; ++n)
        e.period_increments.push_back(
            over_runs([&](auto& run, double level) { return increment_at(run, n, level); },
                      [&](auto& error) { return error[n] - error[n - 1]; })
                .at_confidence);
    std::vector<Estimate> wobble;
    for (const RunEvaluation& run : e.runs)
        if (run.wobble) wobble.push_back(*run.wobble);
    if (!wobble.empty()) e.wobble = repeated(wobble, e.confidence);
    e.settled_shift = over_runs(
        [](auto& run, double level) {
            Estimate settled = run.stages.front().settling.settled;  // at verdict_confidence
            const double factor = statistics::normal_quantile(level) /
                                  statistics::normal_quantile(verdict_confidence);
            settled.low = settled.value - factor * (settled.value - settled.low);
            settled.high = settled.value + factor * (settled.high - settled.value);
            return settled;
        },
        [](auto& error) { return error.back(); });
    e.increment = over_runs(
        [](auto& run, double level) {
            const StageEvaluation& stage = run.stages.front();
            return level == verdict_confidence ? stage.increment_95 : stage.increment;
        },
        [](auto& error) { return late_increment(error, verdict_confidence).value; });
}

statistics::Fit line_of(const StageEvaluation& stage, double origin, double confidence) {
    std::vector<double> time = stage.time;
    for (double& t : time) t -= origin;
    return fit_polynomial(time, stage.shift, 1, confidence);
}

void read_limits(ExperimentEvaluation& e) {
    std::vector<Estimate> middle, low, shift;
    for (const RunEvaluation& run : e.runs) {
        e.limits_by_curvature.push_back(
            read_limit(run, &StageEvaluation::by_curvature, e.confidence));
        const auto limit =
            e.limits.emplace_back(read_limit(run, &StageEvaluation::by_increment, e.confidence));
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

LineIntersection intersect(const StageEvaluation& before, const StageEvaluation& after,
                           double confidence) {
    const double origin = after.time.front();  // near the intersection
    const statistics::Fit lines[] = {line_of(before, origin, confidence),
                                     line_of(after, origin, confidence)};
    std::vector<Estimate> numbers;
    std::vector<double> p;
    std::vector<std::vector<double>> correlation(4, std::vector<double>(4, 0.));
    for (std::size_t l = 0; l < 2; ++l)
        for (std::size_t k = 0; k < 2; ++k) {
            const Estimate& number = numbers.emplace_back(lines[l].parameters[k]);
            p.push_back(number.value);
            for (std::size_t j = 0; j < 2; ++j) {
                const double both = number.standard_error * lines[l].parameters[j].standard_error;
                correlation[2 * l + k][2 * l + j] =
                    both > 0 ? lines[l].covariance[k][j] / both : (j == k ? 1. : 0.);
            }
        }
    const auto time = [](const std::vector<double>& x) { return (x[2] - x[0]) / (x[1] - x[3]); };
    const auto shift = [&](const std::vector<double>& x) { return x[0] + x[1] * time(x); };

    LineIntersection result;
    result.slopes[0] = p[1];
    result.slopes[1] = p[3];
    result.time = origin + time(p);
    result.shift = {shift(p), contact::undefined, contact::undefined, contact::undefined};
    // First order fails where the difference of the slopes is not well above its error.
    const double difference = std::abs(p[3] - p[1]);
    if (difference < 3 * std::hypot(numbers[1].standard_error, numbers[3].standard_error))
        return result;
    const double error = statistics::propagate(shift, numbers, correlation).result.standard_error;
    const int freedom = std::min(lines[0].degrees_of_freedom, lines[1].degrees_of_freedom);
    result.shift =
        statistics::with_interval(shift(p), error, statistics::student_t(confidence, freedom));
    return result;
}

std::optional<LimitReading> read_limit(const RunEvaluation& run, State StageEvaluation::*verdict,
                                       double confidence) {
    const auto& stages = run.stages;
    const auto first = std::ranges::find(stages, State::ratcheting, verdict);
    if (first == stages.end()) return {};
    const auto last = std::find_if(std::make_reverse_iterator(first), stages.rend(),
                                   [&](const auto& s) { return s.*verdict == State::shakedown; });
    if (last == stages.rend()) return {};
    LimitReading reading;
    reading.ratcheting = static_cast<std::size_t>(first - stages.begin());
    reading.shakedown = static_cast<std::size_t>(stages.rend() - last) - 1;
    reading.amplitude_low = last->amplitude;
    reading.amplitude_high = first->amplitude;
    reading.lines = intersect(*last, *first, confidence);
    return reading;
}

bool ExperimentEvaluation::is_spoilt() const {
    return !std::ranges::all_of(runs, &RunEvaluation::is_comparable);
}

std::vector<SystematicError> common_errors(const ExperimentEvaluation& e) {
    std::vector<SystematicError> errors;
    if (e.runs.size() < 2) return errors;
    const auto n_values = static_cast<std::size_t>(e.periods) + 1;
    for (const RunEvaluation& run : e.runs)
        for (const SystematicError& one : run.systematic) {
            auto same = std::ranges::find(errors, one.name, &SystematicError::name);
            if (same == errors.end())
                same = errors.insert(same, {one.name, std::vector<double>(n_values, 0.)});
            for (std::size_t n = 0; n < n_values; ++n)
                same->of_shift[n] += one.of_shift[n] * one.of_shift[n];
        }
    for (SystematicError& one : errors)
        for (double& error : one.of_shift)
            error = std::sqrt(error / static_cast<double>(e.runs.size()));
    return errors;
}

double ExperimentEvaluation::creep_per_period() const {
    if (!rolled_as.hold || rolled_as.loads) return 0;
    double drifted = 0;
    for (const RunEvaluation& run : runs) drifted += run.drift.value * run.stages.front().period;
    return drifted / static_cast<double>(runs.size());
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

}  // namespace tricontact::experiments

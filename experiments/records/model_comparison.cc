#include <algorithm>
#include <cmath>

#include "comparisons/resolution/refinement.h"
#include "experiments/records/experiment_evaluation.h"
#include "statistics/estimate.h"

// Predictions of models beside what was measured.
namespace tricontact::experiments {

namespace {

constexpr int known_error = 1'000'000;  // degrees of freedom of a known standard error

// What the record gives: the scatter of its runs, or noise and drift of one.
UncertaintySource source_of_record(const ExperimentEvaluation& e, const Repeated& measured) {
    const double error = measured.at_95.standard_error;
    if (measured.runs < 2)
        return {"noise and drift", error, double(e.runs.front().degrees_of_freedom)};
    const double scatter = error * error - measured.systematic * measured.systematic;
    return {"repeated runs", std::sqrt(std::max(0., scatter)), measured.runs - 1.};
}

}  // namespace

std::optional<bool> Deviation::differs() const {
    if (!has_errors || rest_is_missing || is_spoilt || slides) return {};
    if (is_excluded(error.difference(), creep, error.half_width())) return true;
    if (!error.agrees()) return {};
    return false;
}

std::string name_of_number(const ExperimentEvaluation& e, std::size_t number) {
    return number < e.uncertain_numbers.size() ? e.uncertain_numbers[number] : std::string();
}

double numerical_error(double fine, double coarse) {
    return comparisons::safety_factor * (fine - coarse) / 2;
}

double nonlinear_error(double value, const std::vector<double>& at_ends, double variance) {
    // Times the linear one: an end that is so much further on one side of a smooth response is as
    // much nearer on the other, and the symmetric interval still holds 94 %.
    constexpr double negligible = 1.25;
    double farthest = 0;
    for (const double end : at_ends) farthest = std::max(farthest, std::abs(end - value));
    const double error = farthest / statistics::normal_quantile(.95);
    if (error * error <= negligible * negligible * variance) return 0;
    return std::sqrt(error * error - variance);
}

std::vector<double> half_widths(const ModelPrediction& p,
                                const statistics::Correlations::Matrix& correlation) {
    std::vector<double> widths;
    if (p.raised.empty()) return widths;
    for (std::size_t n = 0; n < p.shift.size(); ++n) {
        std::vector<double> changes;
        for (const std::vector<double>& raised : p.raised)
            changes.push_back(raised[n] - p.shift[n]);
        double squares = statistics::combined_variance(changes, correlation);
        std::vector<double> at_ends;
        for (const std::vector<double>& end : p.ends) at_ends.push_back(end[n]);
        squares += std::pow(nonlinear_error(p.shift[n], at_ends, squares), 2);
        if (!p.coarser.empty()) squares += std::pow(numerical_error(p.shift[n], p.coarser[n]), 2);
        if (!p.steps_error.empty()) squares += std::pow(p.steps_error[n], 2);
        widths.push_back(statistics::normal_quantile(.95) * std::sqrt(squares));
    }
    return widths;
}

void add_prediction(ExperimentEvaluation& e, ModelPrediction prediction) {
    const double n = e.periods;
    const auto errors = common_errors(e);
    const auto add = [&](const char* name, const Repeated& measured, double n_drifted, auto&& of) {
        const double value = of(prediction.shift);
        ComparisonError error{measured.at_95.value, value, {source_of_record(e, measured)}};
        std::vector<double> changes;
        for (std::size_t i = 0; i < prediction.raised.size(); ++i) {
            const double change = of(prediction.raised[i]) - value;
            changes.push_back(change);
            error.sources.push_back({name_of_number(e, i), std::abs(change)});
        }
        for (const SystematicError& one : errors)
            error.sources.push_back({one.name, std::abs(of(one.of_shift))});
        double variance = statistics::combined_variance(changes, e.correlation);
        std::vector<double> at_ends;
        for (const std::vector<double>& end : prediction.ends) at_ends.push_back(of(end));
        if (const double more = nonlinear_error(value, at_ends, variance); more > 0) {
            error.sources.push_back({nonlinear_response, more});
            variance += more * more;
        }
        error.covariance = statistics::covariance_part(changes, e.correlation);
        if (!prediction.coarser.empty())
            error.sources.push_back(
                {"mesh", std::abs(numerical_error(value, of(prediction.coarser)))});
        if (!prediction.steps_error.empty())
            error.sources.push_back({"steps", std::abs(of(prediction.steps_error))});
        Deviation d{prediction.model, name, measured.at_confidence,
                    statistics::with_interval(value, std::sqrt(variance),
                                              statistics::student_t(e.confidence, known_error))};
        d.has_errors = !prediction.raised.empty();
        d.error = std::move(error);
        d.rest_is_missing = e.rest_is_missing();
        d.is_spoilt = e.is_spoilt();
        d.slides = prediction.slides_within;
        d.creep = n_drifted * e.creep_per_period();
        e.deviations.push_back(std::move(d));
    };
    add("U_stat", e.static_shift, 0, [](const std::vector<double>& u) { return u.front(); });
    if (e.kind == Experiment::Kind::shakedown)
        add("U_sd", e.final_shift, n, [](const std::vector<double>& u) { return u.back(); });
    else
        add("ΔU", e.increment, 1,
            [&](const std::vector<double>& u) { return late_increment(u, e.confidence).value; });
    e.series.push_back(series_deviation(e, prediction));
    e.predictions.push_back(std::move(prediction));
}

}  // namespace tricontact::experiments

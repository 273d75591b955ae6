#include "experiments/records/series_deviation.h"

#include <algorithm>
#include <cmath>

#include "experiments/records/experiment_evaluation.h"
#include "experiments/validation/run_scatter.h"

namespace tricontact::experiments {

namespace {

SeriesSource noise_and_drift(const RunEvaluation& run, std::size_t n_values) {
    const StageEvaluation& stage = run.stages.front();
    SeriesSource source{"noise and drift", {{}, {}}, {}, double(run.degrees_of_freedom)};
    for (std::size_t n = 0; n < n_values; ++n) {
        const double noise = stage.noise_error[n],
                     drift = run.drift.standard_error * stage.drift_time[n];
        const double zero_squared =
            std::pow(stage.shift_error[n], 2) - noise * noise - drift * drift;
        source.common[0].push_back(drift);
        source.common[1].push_back(std::sqrt(std::max(0., zero_squared)));
        source.independent.push_back(noise);
    }
    return source;
}

std::vector<SeriesSource> sources_of_series(const ExperimentEvaluation& e) {
    if (e.runs.size() == 1) return {noise_and_drift(e.runs.front(), e.shift.size())};
    std::vector<std::vector<double>> runs;
    for (const RunEvaluation& run : e.runs) {
        const std::vector<double>& shift = run.stages.front().shift;
        runs.emplace_back(shift.begin(),
                          shift.begin() + static_cast<std::ptrdiff_t>(e.shift.size()));
    }
    std::vector<SeriesSource> sources = scatter_of_mean("repeated runs", runs);
    for (SystematicError& one : common_errors(e))
        sources.push_back({one.name, {std::move(one.of_shift)}});
    return sources;
}

// Of a response that is not linear, beyond what `numbers` tell of it.
SeriesSource nonlinear_source(const ModelPrediction& p, const std::vector<SeriesSource>& numbers,
                              const statistics::Correlations::Matrix& correlation) {
    SeriesSource source{nonlinear_response, {{}}};
    for (std::size_t n = 0; n < p.shift.size(); ++n) {
        std::vector<double> changes, at_ends;
        for (const SeriesSource& number : numbers) changes.push_back(number.common.front()[n]);
        for (const std::vector<double>& end : p.ends) at_ends.push_back(end[n]);
        source.common[0].push_back(nonlinear_error(
            p.shift[n], at_ends, statistics::combined_variance(changes, correlation)));
    }
    return source;
}

}  // namespace

std::optional<bool> SeriesDeviation::differs() const {
    if (!has_errors || rest_is_missing || is_spoilt || slides) return {};
    for (std::size_t n = 0; n < error.values.size(); ++n)
        if (is_excluded(error.values[n].difference(), creep(n), error.half_width(n))) return true;
    if (!error.agrees()) return {};
    return false;
}

SeriesDeviation series_deviation(const ExperimentEvaluation& e, const ModelPrediction& prediction) {
    std::vector<double> measured;
    for (const Estimate& shift : e.shift) measured.push_back(shift.value);
    std::vector<SeriesSource> sources;
    for (std::size_t i = 0; i < prediction.raised.size(); ++i) {
        std::vector<double> change = prediction.raised[i];
        for (std::size_t n = 0; n < change.size(); ++n) change[n] -= prediction.shift[n];
        sources.push_back({name_of_number(e, i), {std::move(change)}});
    }
    if (!prediction.ends.empty()) {
        SeriesSource source = nonlinear_source(prediction, sources, e.correlation);
        if (std::ranges::any_of(source.common[0], [](double error) { return error > 0; }))
            sources.push_back(std::move(source));
    }
    if (!prediction.steps_error.empty()) sources.push_back({"steps", {prediction.steps_error}});
    if (!prediction.coarser.empty()) {
        std::vector<double> change;
        for (std::size_t n = 0; n < measured.size(); ++n)
            change.push_back(numerical_error(prediction.shift[n], prediction.coarser[n]));
        sources.push_back({"mesh", {std::move(change)}});
    }
    for (SeriesSource& source : sources_of_series(e)) sources.push_back(std::move(source));

    return {prediction.model,
            series_error(measured, prediction.shift, sources, e.correlation),
            !prediction.raised.empty(),
            e.rest_is_missing(),
            e.is_spoilt(),
            prediction.slides_within,
            e.creep_per_period()};
}

}  // namespace tricontact::experiments

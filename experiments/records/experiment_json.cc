#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "contact/base/special_values.h"
#include "experiments/records/experiment_report.h"
#include "report/json_table.h"

namespace tricontact::experiments {

using json = nlohmann::ordered_json;
namespace names = comparisons::quantities;

static void to_json(json& to, const Repeated& r) {
    to = {{"runs", r.runs}, {"at_confidence", r.at_confidence}, {"at_95_percent", r.at_95}};
}

// An error of 0 is one that was not stated.
static json uncertain(const Estimate& u) {
    return {{"value", u.value},
            {"standard_error", u.standard_error > 0 ? json(u.standard_error) : json()}};
}

static json predicted_json(const Deviation& d) {
    if (d.has_errors) return d.predicted;
    return Estimate{d.predicted.value, contact::undefined, contact::undefined, contact::undefined};
}

static json comparison_json(const Deviation& d) {
    json sources = json::array();
    for (const UncertaintySource& one : d.error.sources)
        sources.push_back({{"name", one.name}, {"standard_error_m", one.standard_error}});
    return {{"difference_m", d.error.difference()},
            {"half_width_95_percent_m", d.has_errors ? json(d.error.half_width()) : json()},
            {"resolution", d.has_errors ? json(d.error.resolution()) : json()},
            {"sources", sources},
            {"covariance_m2", d.error.covariance}};
}

json deviation_json(const Deviation& d) {
    return {{"quantity", d.quantity},           {"measured_m", d.measured},
            {"predicted_m", predicted_json(d)}, {"measured_over_predicted", d.ratio()},
            {"comparison", comparison_json(d)}, {"differs", d.differs()}};
}

static json range_json(const RecordedPath::Range& range) {
    if (!range.is_recorded) return nullptr;
    return {{"low", range.low}, {"mean", range.mean}, {"high", range.high}};
}

static json loads_json(const std::optional<RecordedLoads>& loads) {
    if (!loads) return nullptr;
    return {{names::normal_force.key, range_json(loads->as_recorded.normal_force)},
            {"tangential_force_N", range_json(loads->as_recorded.tangential_force)}};
}

json series_json(const SeriesDeviation& d) {
    std::vector<double> differences, half_widths;
    for (std::size_t n = 0; n < d.error.values.size(); ++n) {
        differences.push_back(d.error.values[n].difference());
        half_widths.push_back(d.error.half_width(n));
    }
    json shares = json::object();
    for (const auto& [name, share] : d.error.values[d.error.furthest()].shares())
        shares[name] = share;
    const auto stated = [&](const json& value) { return d.has_errors ? value : json(); };
    return {{"difference_m", differences},
            {"half_width_95_percent_m", stated(half_widths)},
            {"widening", stated(d.error.widening)},
            {"furthest_period", stated(d.error.furthest())},
            {"resolution", stated(d.error.resolution)},
            {"shares", stated(shares)},
            {"differs", d.differs()}};
}

static json rolled_json(const ExperimentEvaluation& e) {
    const RolledAs& as = e.rolled_as;
    return {{"rest_under_load_s", e.rest.time},
            {"rest_is_whole", e.rest.is_whole},
            {"hold_s", as.hold},
            {"hold_is_known", as.hold ? json(as.hold_is_known) : json()},
            {"speed_m_per_s", as.speed},
            {"recorded_forces", loads_json(as.loads)},
            {"numbers_with_errors", e.uncertain_numbers}};
}

static json drift_json(const Estimate& d) {
    return {{"value", d.value}, {"standard_error", d.standard_error}};
}

static void to_json(json& to, const StageEvaluation& s) {
    to = {{names::amplitude.key, s.amplitude > 0 ? json(s.amplitude) : json()},
          {"period_s", s.period},
          {"time_s", s.time},
          {"shift_m", s.shift},
          {"shift_standard_error_m", s.shift_error},
          {"increment_m", s.increment},
          {"ratcheting_increment_m", s.settling.increment},
          {names::settled_shift.key, s.settling.settled},
          {"transient_ratio", s.settling.ratio},
          {"residual_deviation_m", s.settling.residual_deviation},
          {"state_by_increment", contact::name_of(s.by_increment)},
          {"curvature", s.curvature},
          {"curvature_of_samples", s.sampled_curvature},
          {"state_by_curvature", contact::name_of(s.by_curvature)}};
}

static void to_json(json& to, const RecordFinding& finding) {
    to = {{"kind", name_of(finding.kind)},
          {"sentence", finding.sentence},
          {"spoils", finding.spoils}};
}

json run_json(const RunEvaluation& run) {
    return {{"name", run.name},
            {"findings", run.findings},
            {"loading_s", run.rest_is_whole ? json(run.loading) : json()},
            {"noise_m", run.noise.standard_deviation},
            {"resolution_m", run.noise.resolution},
            {"correlated_samples", run.noise.correlated_samples},
            {"drift_before_m_per_s", drift_json(run.before)},
            {"drift_after_m_per_s", run.after ? drift_json(*run.after) : json()},
            {"drift_m_per_s", drift_json(run.drift)},
            {"drift_changes", run.drift_changes},
            {"wobble_ratio", run.wobble},
            {"stages", run.stages}};
}

void to_json(json& to, const LimitReading& limit) {
    to = {{"last_shakedown_m", limit.amplitude_low},
          {"first_ratcheting_m", limit.amplitude_high},
          {"intersection_time_s", limit.lines.time},
          {"intersection_shift_m", limit.lines.shift}};
}

static json limits_json(const ExperimentEvaluation& e) {
    if (e.kind != Experiment::Kind::limit) return nullptr;
    return {{"runs", e.limits},
            {"runs_by_curvature", e.limits_by_curvature},
            {names::amplitude.key, e.limit_amplitude},
            {"last_shakedown_m", e.last_shakedown},
            {"shift_m", e.limit_shift}};
}

json normalised_json(const NormalisedResults& n) {
    return {{names::tangential_ratio.key, uncertain(n.tangential_ratio)},
            {names::amplitude_ratio.key, uncertain(n.amplitude_ratio)},
            {names::unit_shift.key, uncertain(n.unit_shift)},
            {names::static_shift_ratio.key, uncertain(n.static_ratio)},
            {names::final_shift_ratio.key, uncertain(n.final_ratio)},
            {"increment_ratio", uncertain(n.increment_ratio)},
            {"exact_amplitude_limit", uncertain(n.exact_limit)},
            {"exact_amplitude_limit_m", uncertain(n.exact_limit_amplitude)},
            {"thesis_amplitude_limit", uncertain(n.thesis_limit)}};
}

static json models_json(const ExperimentEvaluation& e) {
    json models = json::array();
    for (const ModelPrediction& p : e.predictions) {
        const auto series = std::ranges::find(e.series, p.model, &SeriesDeviation::model);
        json deviations = json::array();
        for (const Deviation& d : e.deviations)
            if (d.model == p.model) deviations.push_back(deviation_json(d));
        models.push_back(
            {{"model", p.model},
             {names::state.key, contact::name_of(p.state)},
             {"chance_of_ratcheting", p.chance_of_ratcheting},
             {"slides_within_uncertainty", p.slides_within},
             {"shift_m", p.shift},
             {"wobble_ratio", p.wobble},
             {"pivot_height_m", e.wobble ? uncertain(pivot_height(e, p.wobble)) : json()},
             {"deviations", deviations},
             {"series", series == e.series.end() ? json() : series_json(*series)}});
    }
    for (const PredictedLimit& limit : e.model_limits)
        models.push_back({{"model", limit.model},
                          {"state_per_stage", report::list_of(limit.states, contact::name_of)}});
    return models;
}

std::string experiment_json(const std::string& version, const ExperimentEvaluation& e,
                            const json& laws) {
    const json document{{"version", version},
                        {"title", e.title},
                        {"confidence", e.confidence},
                        {"verdict_confidence", verdict_confidence},
                        {names::state.key, contact::name_of(e.state)},
                        {names::periods.key, e.periods},
                        {names::amplitude.key, e.amplitude > 0 ? json(e.amplitude) : json()},
                        {names::static_shift.key, e.static_shift},
                        {names::final_shift.key, e.final_shift},
                        {names::settled_shift.key,
                         e.state == contact::State::ratcheting ? json() : json(e.settled_shift)},
                        {"increment_m", e.increment},
                        {"shift_per_period_m", e.shift},
                        {"increment_per_period_m", e.period_increments},
                        {"wobble_ratio", e.wobble},
                        {"limit", limits_json(e)},
                        {"normalised", e.normalised ? normalised_json(*e.normalised) : json()},
                        {"rolled_as", rolled_json(e)},
                        {"models", models_json(e)},
                        {"laws", laws},
                        {"runs", report::list_of(e.runs, run_json)}};
    return document.dump(2) + '\n';
}

}  // namespace tricontact::experiments

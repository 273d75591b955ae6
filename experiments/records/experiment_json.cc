#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "experiments/records/experiment_report.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using json = nlohmann::ordered_json;
namespace names = comparisons::quantities;

json estimate(const Estimate& e) {
    return {
        {"value", e.value}, {"standard_error", e.standard_error}, {"low", e.low}, {"high", e.high}};
}

/// Null where `value` is empty.
template <class Value, class JsonOf>
json if_any(const std::optional<Value>& value, const JsonOf& json_of) {
    return value ? json_of(*value) : json();
}

json repeated_json(const Repeated& r) {
    return {{"runs", r.runs},
            {"at_confidence", estimate(r.at_confidence)},
            {"at_95_percent", estimate(r.at_95)}};
}

// An error of 0 is one that was not stated.
json uncertain(const Estimate& u) {
    return {{"value", u.value},
            {"standard_error", u.standard_error > 0 ? json(u.standard_error) : json()}};
}

json predicted_json(const Deviation& d) {
    if (d.has_errors) return estimate(d.predicted);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return estimate({d.predicted.value, none, none, none});
}

json rolled_json(const ExperimentEvaluation& e) {
    const RolledAs& as = e.rolled_as;
    return {{"rest_under_load_s", e.rest.time},
            {"rest_is_whole", e.rest.is_whole},
            {"hold_s", as.hold},
            {"hold_is_known", as.hold ? json(as.hold_is_known) : json()},
            {"speed_m_per_s", as.speed},
            {"numbers_with_errors", e.uncertain_numbers}};
}

json drift_json(const Estimate& d) {
    return {{"value", d.value}, {"standard_error", d.standard_error}};
}

json stage_json(const StageEvaluation& s) {
    return {{names::amplitude.key, s.amplitude > 0 ? json(s.amplitude) : json()},
            {"period_s", s.period},
            {"time_s", s.time},
            {"shift_m", s.shift},
            {"shift_standard_error_m", s.shift_error},
            {"increment_m", estimate(s.increment)},
            {"steady_walk_m", estimate(s.settling.increment)},
            {names::settled_shift.key, estimate(s.settling.settled)},
            {"transient_ratio", s.settling.ratio},
            {"residual_deviation_m", s.settling.residual_deviation},
            {"state_by_walk", contact::name_of(s.by_walk)},
            {"curvature", estimate(s.curvature)},
            {"curvature_of_samples", s.sampled_curvature},
            {"state_by_curvature", contact::name_of(s.by_curvature)}};
}

json run_json(const RunEvaluation& run) {
    return {{"name", run.name},
            {"noise_m", run.noise.standard_deviation()},
            {"resolution_m", run.noise.resolution()},
            {"correlated_samples", run.noise.correlated_samples()},
            {"drift_before_m_per_s", drift_json(run.before)},
            {"drift_after_m_per_s", if_any(run.after, drift_json)},
            {"drift_m_per_s", drift_json(run.drift)},
            {"drift_changes", run.drift_changes},
            {"wobble_ratio", if_any(run.wobble, estimate)},
            {"stages", report::list_of(run.stages, stage_json)}};
}

json limit_json(const std::optional<LimitReading>& limit) {
    if (!limit) return nullptr;
    return {{"last_shakedown_m", limit->amplitude_low},
            {"first_ratcheting_m", limit->amplitude_high},
            {"intersection_time_s", limit->lines.time},
            {"intersection_shift_m", estimate(limit->lines.shift)}};
}

json limits_json(const ExperimentEvaluation& e) {
    if (e.kind != Experiment::Kind::limit) return nullptr;
    return {{"runs", report::list_of(e.limits, limit_json)},
            {"runs_by_curvature", report::list_of(e.limits_by_curvature, limit_json)},
            {names::amplitude.key, if_any(e.limit_amplitude, repeated_json)},
            {"last_shakedown_m", if_any(e.last_shakedown, repeated_json)},
            {"shift_m", if_any(e.limit_shift, repeated_json)}};
}

json normalised_json(const NormalisedResults& n) {
    return {{names::tangential_ratio.key, uncertain(n.tangential_ratio)},
            {names::amplitude_ratio.key, uncertain(n.amplitude_ratio)},
            {names::unit_shift.key, uncertain(n.unit_shift)},
            {names::static_shift_ratio.key, uncertain(n.static_ratio)},
            {names::final_shift_ratio.key, uncertain(n.final_ratio)},
            {"increment_ratio", uncertain(n.increment_ratio)},
            {"exact_amplitude_limit", uncertain(n.exact_limit)},
            {"thesis_amplitude_limit", uncertain(n.thesis_limit)}};
}

json models_json(const ExperimentEvaluation& e) {
    json models = json::array();
    for (const ModelPrediction& p : e.predictions) {
        json deviations = json::array();
        for (const Deviation& d : e.deviations)
            if (d.model == p.model)
                deviations.push_back({{"quantity", d.quantity},
                                      {"measured_m", estimate(d.measured)},
                                      {"predicted_m", predicted_json(d)},
                                      {"measured_over_predicted", d.ratio()},
                                      {"differs", d.differs()}});
        models.push_back(
            {{"model", p.model},
             {names::state.key, contact::name_of(p.state)},
             {"shift_m", p.shift},
             {"wobble_ratio", p.wobble},
             {"pivot_height_m", e.wobble ? uncertain(pivot_height(e, p.wobble)) : json()},
             {"deviations", deviations}});
    }
    for (const PredictedLimit& limit : e.model_limits)
        models.push_back({{"model", limit.model},
                          {"state_per_stage", report::list_of(limit.states, contact::name_of)}});
    return models;
}

}  // namespace

std::string experiment_json(const std::string& version, const ExperimentEvaluation& e) {
    const json document{{"version", version},
                        {"title", e.title},
                        {"confidence", e.confidence},
                        {"verdict_confidence", verdict_confidence},
                        {names::state.key, contact::name_of(e.state)},
                        {names::periods.key, e.periods},
                        {names::amplitude.key, e.amplitude > 0 ? json(e.amplitude) : json()},
                        {names::static_shift.key, repeated_json(e.static_shift)},
                        {names::final_shift.key, repeated_json(e.final_shift)},
                        {names::settled_shift.key, repeated_json(e.settled_shift)},
                        {"increment_m", repeated_json(e.increment)},
                        {"shift_per_period_m", report::list_of(e.shift, estimate)},
                        {"increment_per_period_m", report::list_of(e.period_increments, estimate)},
                        {"wobble_ratio", if_any(e.wobble, repeated_json)},
                        {"limit", limits_json(e)},
                        {"normalised", if_any(e.normalised, normalised_json)},
                        {"rolled_as", rolled_json(e)},
                        {"models", models_json(e)},
                        {"runs", report::list_of(e.runs, run_json)}};
    return document.dump(2) + '\n';
}

}  // namespace tricontact::experiments

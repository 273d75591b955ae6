#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "experiments/records/experiment_report.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using json = nlohmann::ordered_json;

json estimate(const statistics::Estimate& e) {
    return {{"value", report::number(e.value)},
            {"standard_error", report::number(e.standard_error)},
            {"low", report::number(e.low)},
            {"high", report::number(e.high)}};
}

json repeated_json(const Repeated& r) {
    return {{"runs", r.runs},
            {"at_confidence", estimate(r.at_confidence)},
            {"at_95_percent", estimate(r.at_95)}};
}

// An error of 0 is one that nobody stated.
json uncertain(const statistics::Uncertain& u) {
    return {{"value", report::number(u.value)},
            {"standard_error", u.standard_error > 0 ? report::number(u.standard_error) : json()}};
}

json predicted_json(const Deviation& d) {
    if (d.has_errors) return estimate(d.predicted);
    return {{"value", report::number(d.predicted.value)},
            {"standard_error", nullptr},
            {"low", nullptr},
            {"high", nullptr}};
}

json rolled_json(const ExperimentEvaluation& e) {
    const RolledAs& as = e.rolled_as;
    return {{"rest_under_load_s", e.rest.time},
            {"rest_is_whole", e.rest.is_whole},
            {"hold_s", as.hold ? json(*as.hold) : json()},
            {"hold_is_known", as.hold ? json(as.hold_is_known) : json()},
            {"speed_m_per_s", as.speed ? json(*as.speed) : json()},
            {"numbers_with_errors", e.uncertain_numbers}};
}

json drift_json(const Drift& d) {
    return {{"value", report::number(d.value)},
            {"standard_error", report::number(d.standard_error)}};
}

json stage_json(const StageEvaluation& s) {
    return {{comparisons::quantities::amplitude.key, s.amplitude > 0 ? json(s.amplitude) : json()},
            {"period_s", s.period},
            {"time_s", report::numbers(s.time)},
            {"shift_m", report::numbers(s.shift)},
            {"shift_standard_error_m", report::numbers(s.shift_error)},
            {"increment_m", estimate(s.increment)},
            {"steady_walk_m", estimate(s.settling.increment)},
            {comparisons::quantities::settled_shift.key, estimate(s.settling.settled)},
            {"transient_ratio", report::number(s.settling.ratio)},
            {"residual_deviation_m", report::number(s.settling.residual_deviation)},
            {"state_by_walk", contact::name_of(s.by_walk)},
            {"curvature", estimate(s.curvature)},
            {"curvature_of_samples", report::number(s.sampled_curvature)},
            {"state_by_curvature", contact::name_of(s.by_curvature)}};
}

json run_json(const RunEvaluation& run) {
    json stages = json::array();
    for (const StageEvaluation& stage : run.stages) stages.push_back(stage_json(stage));
    return {{"name", run.name},
            {"noise_m", report::number(run.noise.standard_deviation())},
            {"resolution_m", report::number(run.noise.resolution())},
            {"correlated_samples", report::number(run.noise.correlated_samples())},
            {"drift_before_m_per_s", drift_json(run.before)},
            {"drift_after_m_per_s", run.after ? drift_json(*run.after) : json()},
            {"drift_m_per_s", drift_json(run.drift)},
            {"drift_changes", run.drift_changes},
            {"wobble_ratio", run.wobble ? estimate(*run.wobble) : json()},
            {"stages", stages}};
}

json limit_json(const std::optional<LimitReading>& limit) {
    if (!limit) return nullptr;
    return {{"last_shakedown_m", limit->amplitude_low},
            {"first_ratcheting_m", limit->amplitude_high},
            {"intersection_time_s", report::number(limit->lines.time)},
            {"intersection_shift_m", estimate(limit->lines.shift)}};
}

json limits_json(const ExperimentEvaluation& e) {
    if (e.kind != Experiment::Kind::limit) return nullptr;
    json runs = json::array(), by_curvature = json::array();
    for (const auto& limit : e.limits) runs.push_back(limit_json(limit));
    for (const auto& limit : e.limits_by_curvature) by_curvature.push_back(limit_json(limit));
    const auto all = [](const std::optional<Repeated>& r) {
        return r ? repeated_json(*r) : json();
    };
    return {{"runs", runs},
            {"runs_by_curvature", by_curvature},
            {comparisons::quantities::amplitude.key, all(e.limit_amplitude)},
            {"last_shakedown_m", all(e.last_shakedown)},
            {"shift_m", all(e.limit_shift)}};
}

json normalised_json(const std::optional<NormalisedResults>& n) {
    if (!n) return nullptr;
    return {{comparisons::quantities::tangential_ratio.key, uncertain(n->tangential_ratio)},
            {comparisons::quantities::amplitude_ratio.key, uncertain(n->amplitude_ratio)},
            {comparisons::quantities::unit_shift.key, uncertain(n->unit_shift)},
            {comparisons::quantities::static_shift_ratio.key, uncertain(n->static_ratio)},
            {comparisons::quantities::final_shift_ratio.key, uncertain(n->final_ratio)},
            {"increment_ratio", uncertain(n->increment_ratio)},
            {"exact_amplitude_limit", uncertain(n->exact_limit)},
            {"thesis_amplitude_limit", uncertain(n->thesis_limit)}};
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
                                      {"measured_over_predicted", report::number(d.ratio())},
                                      {"differs", d.differs() ? json(*d.differs()) : json()}});
        models.push_back(
            {{"model", p.model},
             {comparisons::quantities::state.key, contact::name_of(p.state)},
             {"shift_m", report::numbers(p.shift)},
             {"wobble_ratio", report::number(p.wobble)},
             {"pivot_height_m", e.wobble ? uncertain(pivot_height(e, p.wobble)) : json()},
             {"deviations", deviations}});
    }
    for (const PredictedLimit& limit : e.model_limits) {
        json states = json::array();
        for (const contact::State state : limit.states) states.push_back(contact::name_of(state));
        models.push_back({{"model", limit.model}, {"state_per_stage", states}});
    }
    return models;
}

}  // namespace

std::string experiment_json(const std::string& version, const ExperimentEvaluation& e) {
    json shift = json::array();
    for (const statistics::Estimate& u : e.shift) shift.push_back(estimate(u));
    json increments = json::array();
    for (const statistics::Estimate& d : e.period_increments) increments.push_back(estimate(d));
    json runs = json::array();
    for (const RunEvaluation& run : e.runs) runs.push_back(run_json(run));
    const json document{
        {"version", version},
        {"title", e.title},
        {"confidence", e.confidence},
        {"verdict_confidence", verdict_confidence},
        {comparisons::quantities::state.key, contact::name_of(e.state)},
        {comparisons::quantities::periods.key, e.periods},
        {comparisons::quantities::amplitude.key, e.amplitude > 0 ? json(e.amplitude) : json()},
        {comparisons::quantities::static_shift.key, repeated_json(e.static_shift)},
        {comparisons::quantities::final_shift.key, repeated_json(e.final_shift)},
        {comparisons::quantities::settled_shift.key, repeated_json(e.settled_shift)},
        {"increment_m", repeated_json(e.increment)},
        {"shift_per_period_m", shift},
        {"increment_per_period_m", increments},
        {"wobble_ratio", e.wobble ? repeated_json(*e.wobble) : json()},
        {"limit", limits_json(e)},
        {"normalised", normalised_json(e.normalised)},
        {"rolled_as", rolled_json(e)},
        {"models", models_json(e)},
        {"runs", runs}};
    return document.dump(2) + '\n';
}

}  // namespace tricontact::experiments

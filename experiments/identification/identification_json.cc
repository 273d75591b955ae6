
#include "experiments/identification/identification_report.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using json = nlohmann::ordered_json;

// An open end of an interval is null.
json interval_json(const Interval& interval) {
    return json::array({interval.low, interval.high});
}

json estimate_json(const IdentifiedModel& model, Property property) {
    const auto& estimate = model.found[property];
    if (!estimate) return nullptr;
    json inputs = json::object();
    for (const InputContribution& input : model.contributions)
        inputs[input.key] = input.change[property];
    return {{"value", estimate->value},
            {"standard_error", estimate->standard_error},
            {"interval", interval_json(full_interval(model, property))},
            {"linearised_interval", interval_json({estimate->low, estimate->high})},
            {"likelihood_interval", interval_json(estimate->likelihood)},
            {"change_by_standard_errors_of_inputs", inputs},
            {"combined_standard_error", combined_standard_error(model, property)}};
}

json posterior_json(const IdentifiedModel& model) {
    if (!model.posterior) return nullptr;
    const Posterior& p = *model.posterior;
    json result{{"points", p.points.size()},
                {"effective_size", p.effective_size},
                {"autocorrelation_time", p.autocorrelation_time},
                {"acceptance", p.acceptance},
                {"correlation", p.correlation}};
    for (const Property property : both_properties)
        if (model.found[property])
            result[property == Property::young ? "young_Pa" : "friction_coefficient"] = {
                {"median", p.median[property]}, {"interval", interval_json(p.interval[property])}};
    return result;
}

json model_json(const IdentifiedModel& model) {
    const Identification& found = model.found;
    return {{"young_Pa", estimate_json(model, Property::young)},
            {"friction_coefficient", estimate_json(model, Property::friction)},
            {"correlation", found.correlation},
            {"sum_of_squares", found.sum_of_squares},
            {"degrees_of_freedom", found.degrees_of_freedom},
            {"residual_standard_deviation", found.residual_standard_deviation},
            {"r_squared", found.r_squared},
            {"goodness", found.goodness},
            {"interpolation_error", model.interpolation_error},
            {"posterior", posterior_json(model)},
            {"fitted", found.fitted},
            {"residuals", found.residuals}};
}

}  // namespace

json identification_json(const IdentificationStudy& study) {
    json result;
    result["version"] = study.version;
    result["command"] = study.command;
    result["title"] = study.title;
    result["measurement"] = name_of(study.input.measurement);
    result["confidence"] = study.models.front().found.confidence;
    for (const auto& [name, value] : study.settings) result["settings"][name] = value;
    result["given"] = study.input.given;
    result["observed"] = study.input.observed;
    result["standard_errors"] = study.input.standard_errors;
    const IdentifiedModel& reference = reference_model(study);
    result["reference"] = reference.name;
    result["thickness_over_contact_width"] = study.thickness_ratio;
    for (const IdentifiedModel& model : study.models) {
        json values = model_json(model);
        if (model.found.young)
            values["young_over_reference"] = model.found.best.young / reference.found.best.young;
        if (model.found.friction)
            values["friction_over_reference"] =
                model.found.best.friction / reference.found.best.friction;
        result["models"][model.name] = std::move(values);
    }
    result["verdicts"] = report::list_of(identification_verdicts(study),
                                         [](const auto& verdict) { return verdict.sentence; });
    return result;
}

}  // namespace tricontact::experiments

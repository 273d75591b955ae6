#include <cmath>

#include "experiments/identification/identification_report.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using json = nlohmann::ordered_json;

// An open end of an interval is null.
json interval_json(const Interval& interval) {
    return json::array({report::number(interval.low), report::number(interval.high)});
}

json estimate_json(const IdentifiedModel& model, Property property) {
    const auto& estimate = property == Property::young ? model.found.young : model.found.friction;
    if (!estimate) return nullptr;
    json inputs = json::object();
    for (const InputContribution& input : model.contributions)
        inputs[input.key] = report::number(property == Property::young ? input.change.young
                                                                       : input.change.friction);
    return {{"value", report::number(estimate->value)},
            {"standard_error", report::number(estimate->standard_error)},
            {"interval", interval_json(full_interval(model, property))},
            {"linearised_interval", interval_json(estimate->linearised)},
            {"likelihood_interval", interval_json(estimate->likelihood)},
            {"change_by_standard_errors_of_inputs", inputs},
            {"combined_standard_error", report::number(combined_standard_error(model, property))}};
}

json model_json(const IdentifiedModel& model) {
    const Identification& found = model.found;
    json result;
    result["young_Pa"] = estimate_json(model, Property::young);
    result["friction_coefficient"] = estimate_json(model, Property::friction);
    result["correlation"] = report::number(found.correlation);
    result["sum_of_squares"] = report::number(found.sum_of_squares);
    result["degrees_of_freedom"] = found.degrees_of_freedom;
    result["residual_standard_deviation"] = report::number(found.residual_standard_deviation);
    result["r_squared"] = report::number(found.r_squared);
    result["goodness"] = report::number(found.goodness);
    result["interpolation_error"] = report::number(model.interpolation_error);
    result["fitted"] = report::numbers(found.fitted);
    result["residuals"] = report::numbers(found.residuals);
    return result;
}

}  // namespace

json identification_json(const IdentificationStudy& study) {
    json result;
    result["version"] = study.version;
    result["command"] = study.command;
    result["title"] = study.title;
    result["measurement"] = study.measurement;
    result["confidence"] = study.models.front().found.confidence;
    for (const auto& [name, value] : study.settings) result["settings"][name] = value;
    result["given"] = report::numbers(study.given_values);
    result["observed"] = report::numbers(study.observed_values);
    result["standard_errors"] = report::numbers(study.standard_errors);
    const IdentifiedModel& reference = reference_model(study);
    result["reference"] = reference.name;
    result["thickness_over_contact_width"] = report::number(study.thickness_ratio);
    for (const IdentifiedModel& model : study.models) {
        json values = model_json(model);
        if (model.found.young)
            values["young_over_reference"] =
                report::number(model.found.best.young / reference.found.best.young);
        if (model.found.friction)
            values["friction_over_reference"] =
                report::number(model.found.best.friction / reference.found.best.friction);
        result["models"][model.name] = std::move(values);
    }
    std::vector<std::string> sentences;
    for (const report::Verdict& verdict : identification_verdicts(study))
        sentences.push_back(verdict.sentence);
    result["verdicts"] = sentences;
    return result;
}

}  // namespace tricontact::experiments

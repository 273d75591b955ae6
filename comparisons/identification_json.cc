#include <cmath>

#include "comparisons/identification_report.h"
#include "comparisons/json_number.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

// An open end of an interval is null.
json interval_json(const Interval& interval) {
    return json::array({number(interval.low), number(interval.high)});
}

json estimate_json(const IdentifiedModel& model, Property property) {
    const auto& estimate = property == Property::young ? model.found.young : model.found.friction;
    if (!estimate) return nullptr;
    json inputs = json::object();
    for (const InputContribution& input : model.contributions)
        inputs[input.key] =
            number(property == Property::young ? input.change.young : input.change.friction);
    return {{"value", number(estimate->value)},
            {"standard_error", number(estimate->standard_error)},
            {"interval", interval_json(full_interval(model, property))},
            {"linearised_interval", interval_json(estimate->linearised)},
            {"likelihood_interval", interval_json(estimate->likelihood)},
            {"change_by_standard_errors_of_inputs", inputs},
            {"combined_standard_error", number(combined_standard_error(model, property))}};
}

json model_json(const IdentifiedModel& model) {
    const Identification& found = model.found;
    json result;
    result["young_Pa"] = estimate_json(model, Property::young);
    result["friction_coefficient"] = estimate_json(model, Property::friction);
    result["correlation"] = number(found.correlation);
    result["sum_of_squares"] = number(found.sum_of_squares);
    result["degrees_of_freedom"] = found.degrees_of_freedom;
    result["residual_standard_deviation"] = number(found.residual_standard_deviation);
    result["r_squared"] = number(found.r_squared);
    result["goodness"] = number(found.goodness);
    result["interpolation_error"] = number(model.interpolation_error);
    result["fitted"] = numbers(found.fitted);
    result["residuals"] = numbers(found.residuals);
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
    result["given"] = numbers(study.given_values);
    result["observed"] = numbers(study.observed_values);
    result["standard_errors"] = numbers(study.standard_errors);
    const IdentifiedModel& reference = reference_model(study);
    result["reference"] = reference.name;
    result["thickness_over_contact_width"] = number(study.thickness_ratio);
    for (const IdentifiedModel& model : study.models) {
        json values = model_json(model);
        if (model.found.young)
            values["young_over_reference"] =
                number(model.found.best.young / reference.found.best.young);
        if (model.found.friction)
            values["friction_over_reference"] =
                number(model.found.best.friction / reference.found.best.friction);
        result["models"][model.name] = std::move(values);
    }
    std::vector<std::string> sentences;
    for (const Verdict& verdict : identification_verdicts(study))
        sentences.push_back(verdict.sentence);
    result["verdicts"] = sentences;
    return result;
}

}  // namespace tricontact::comparisons

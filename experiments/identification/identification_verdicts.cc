#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "experiments/identification/identification_report.h"
#include "report/format.h"
#include "statistics/regression.h"

namespace tricontact::experiments {

namespace {

using report::Verdict;
using enum Verdict::Standing;

// Chance exceeds the sum of squares so rarely that the model is to blame.
constexpr double least_goodness = 0.01;
// A property that moves by less than this is not called different.
constexpr double least_bias = 0.005;

/// "E = 4.2 MPa (4.1 MPa to 4.3 MPa)", "mu above 0.3".
std::string named(const std::string& name, const std::string& value) {
    return name + (value.find_first_of("0123456789") == 0 ? " = " : " ") + value;
}

/// What the interval holds beside the errors of the observed values.
std::string what_else(const IdentificationStudy& study, const IdentifiedModel& model) {
    if (study.input.rig_errors.empty()) return ", the rig's data taken as exact";
    if (model.contributions.empty())
        return "; the errors of the rig's data are left out, since at the best mu the largest "
               "force slides";
    return " and the errors of the rig's data";
}

Verdict values_found(const IdentificationStudy& study, const IdentifiedModel& model) {
    const Identification& found = model.found;
    std::string sentence = model.name + ": ";
    if (found.young) sentence += named("E", shown(model, Property::young));
    if (found.young && found.friction) sentence += ", ";
    if (found.friction) sentence += named("mu", shown(model, Property::friction));
    sentence += fmt::format("; intervals of {:g} %, from the likelihood{}.", 100 * found.confidence,
                            what_else(study, model));
    if (&model == &reference_model(study) && study.models.size() > 1)
        sentence += " This is the most complete model.";
    return {finding, sentence};
}

/// What one standard error of an input does to a property, relative.
double relative_change(const IdentifiedModel& model, const std::string& key, Property property) {
    const auto input = std::ranges::find(model.contributions, key, &InputContribution::key);
    if (input == model.contributions.end()) return 0;
    return input->change[property] / model.found[property]->value;
}

/// Standard error of a property of one model over that of the other by the errors of the inputs,
/// which are the same for both.
double shared_error(const IdentifiedModel& a, const IdentifiedModel& b, Property property) {
    std::set<std::string> keys;
    for (const IdentifiedModel* model : {&a, &b})
        for (const InputContribution& input : model->contributions) keys.insert(input.key);
    double error = 0;
    for (const std::string& key : keys)
        error = std::hypot(error,
                           relative_change(a, key, property) - relative_change(b, key, property));
    return error;
}

/// The intervals of the likelihood overlap, or are no further apart than the inputs' errors move
/// one model's value against the other's.
bool overlap(const IdentifiedModel& a, const IdentifiedModel& b, Property property) {
    const Interval of_a = a.found[property]->likelihood;
    const Interval of_b = b.found[property]->likelihood;
    const double gap = std::max(of_a.low - of_b.high, of_b.low - of_a.high);
    const double reach =
        statistics::normal_quantile(a.found.confidence) * shared_error(a, b, property);
    return gap <= reach * b.found[property]->value;
}

std::string off(double ratio) {
    return fmt::format("{} % too {}", report::significant(100 * std::abs(ratio - 1), 2),
                       ratio > 1 ? "high" : "low");
}

/// What the model that knows less makes of E.
std::optional<Verdict> bias(const IdentificationStudy& study) {
    const IdentifiedModel& reference = reference_model(study);
    const auto half_space = std::ranges::find(study.models, "half-space", &IdentifiedModel::name);
    if (half_space == study.models.end() || &*half_space == &reference || !reference.found.young)
        return {};
    const double ratio = half_space->found.best.young / reference.found.best.young;
    if (std::abs(ratio - 1) < least_bias)
        return Verdict{holds, fmt::format("The half-space finds E within {:.1f} % of {}.",
                                          100 * least_bias, reference.name)};
    std::string sentence =
        fmt::format("The half-space finds E = {}, {} {}: ",
                    report::quantity(half_space->found.best.young, "Pa", 3), reference.name,
                    report::quantity(reference.found.best.young, "Pa", 3));
    if (overlap(*half_space, reference, Property::young))
        return Verdict{
            cannot_tell,
            sentence +
                "their intervals overlap, the measurement does not tell how far they are apart."};
    sentence += off(ratio);
    if (study.thickness_ratio)
        sentence += fmt::format("; the layer is {} contact widths thick",
                                report::significant(*study.thickness_ratio, 2));
    if (half_space->found.friction && !overlap(*half_space, reference, Property::friction))
        sentence +=
            "; its mu is " + off(half_space->found.best.friction / reference.found.best.friction);
    return Verdict{fails, sentence + "."};
}

Verdict explains(const IdentifiedModel& model) {
    const Identification& found = model.found;
    const bool good = *found.goodness >= least_goodness;
    return {
        good ? holds : fails,
        fmt::format("{} {} the measurement: chi^2 = {} with {} degrees of freedom, {} by chance.",
                    model.name, good ? "explains" : "does not explain",
                    report::significant(found.sum_of_squares, 3), found.degrees_of_freedom,
                    report::p_value(*found.goodness))};
}

/// A fit that looks good is no proof of the half-space.
std::optional<Verdict> fit_tells_nothing(const IdentificationStudy& study) {
    const auto good = [](const IdentifiedModel& m) {
        return m.found.goodness && *m.found.goodness >= least_goodness;
    };
    const auto biased = bias(study);
    if (study.models.size() < 2 || !biased || biased->standing != fails ||
        !std::ranges::all_of(study.models, good))
        return {};
    return Verdict{cannot_tell,
                   "The measurement alone does not show which model is right: all of them pass "
                   "through it. The thickness of the layer decides."};
}

}  // namespace

const IdentifiedModel& reference_model(const IdentificationStudy& study) {
    for (const char* name : {"fem", "bem-layer", "atlas", "layer"}) {
        const auto found = std::ranges::find(study.models, name, &IdentifiedModel::name);
        if (found != study.models.end()) return *found;
    }
    return study.models.front();  // the half-space alone
}

std::string shown(const IdentifiedModel& model, Property property) {
    const auto text = [&](double value) {
        return property == Property::young ? report::quantity(value, "Pa", 3)
                                           : report::significant(value, 3);
    };
    const auto [low, high] = full_interval(model, property);
    if (std::isinf(high) && low <= 0) return "cannot be told";
    if (std::isinf(high)) return "above " + text(low);
    if (low <= 0) return "below " + text(high);
    return fmt::format("{} ({} to {})", text(model.found[property]->value), text(low), text(high));
}

double input_standard_error(const IdentifiedModel& model, Property property) {
    double error = 0;
    for (const InputContribution& input : model.contributions)
        error = std::hypot(error, input.change[property]);
    return error;
}

double combined_standard_error(const IdentifiedModel& model, Property property) {
    const auto& estimate = model.found[property];
    return std::hypot(estimate ? estimate->standard_error : 0,
                      input_standard_error(model, property));
}

Interval full_interval(const IdentifiedModel& model, Property property) {
    const PropertyEstimate& estimate = *model.found[property];
    const double half =
        statistics::normal_quantile(model.found.confidence) * input_standard_error(model, property);
    const auto [low, high] = estimate.likelihood;
    return {std::max(0., estimate.value - std::hypot(estimate.value - low, half)),
            estimate.value + std::hypot(high - estimate.value, half)};
}

std::vector<Verdict> identification_verdicts(const IdentificationStudy& study) {
    std::vector<Verdict> verdicts;
    const IdentifiedModel& reference = reference_model(study);
    verdicts.push_back(values_found(study, reference));
    if (auto verdict = bias(study)) verdicts.push_back(std::move(*verdict));
    for (const IdentifiedModel& model : study.models) {
        if (model.found.goodness) verdicts.push_back(explains(model));
        if (model.found.friction && std::isinf(model.found.friction->likelihood.high))
            verdicts.push_back({cannot_tell, model.name +
                                                 " cannot tell mu: all larger ones are as likely. "
                                                 "Measure at larger forces, closer to sliding."});
    }
    if (auto verdict = fit_tells_nothing(study)) verdicts.push_back(std::move(*verdict));
    return verdicts;
}

}  // namespace tricontact::experiments

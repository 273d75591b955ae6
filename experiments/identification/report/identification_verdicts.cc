#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>

#include "experiments/identification/identification_report.h"
#include "experiments/identification/report/loop_report.h"
#include "io/case/measurement_models.h"
#include "report/format.h"
#include "statistics/regression.h"

namespace tricontact::experiments {

namespace {

using io::MeasurementModel;
using report::Verdict;
using enum Verdict::Standing;

const std::string young_key = "substrate.young", friction_key = "friction.coefficient";
// A modulus that moves by less than this is not called different.
constexpr double least_bias = 0.005;

/// "E = 4.2 MPa (4.1 MPa to 4.3 MPa)", "mu above 0.3".
std::string named(const std::string& name, const std::string& value) {
    const bool is_number =
        value.find_first_of("0123456789") == 0 || value.starts_with("\u2212");  // minus
    return name + (is_number ? " = " : " ") + value;
}

/// What the interval holds beside the errors of the observed values.
std::string what_else(const IdentificationStudy& study, const IdentifiedModel& model) {
    const bool has_rig = !study.input.rig_errors.empty();
    const bool has_maps = model.contributions.size() > study.input.rig_errors.size();
    if (has_rig && model.contributions.empty())
        return "; the errors of the rig's data are left out, since at the best mu the largest "
               "force slides";
    if (has_rig)
        return has_maps ? ", the errors of the rig's data and those of the maps"
                        : " and the errors of the rig's data";
    return std::string(has_maps ? " and the errors of the maps" : "") +
           ", the rig's data taken as exact";
}

Verdict values_found(const IdentificationStudy& study, const IdentifiedModel& model) {
    const Identification& found = model.found;
    std::string sentence = model.name + ": ";
    for (std::size_t k = 0; k < found.free.size(); ++k)
        sentence += (k == 0 ? "" : ", ") + named(found.free[k].symbol, shown(model, k));
    const double widening = found.widening.empty() ? 1 : std::ranges::max(found.widening);
    sentence += fmt::format("; intervals of {:g} %, from the likelihood{}{}.",
                            100 * found.confidence, what_else(study, model),
                            widening > 1 ? fmt::format(", up to {} times as wide as for errors "
                                                       "that are independent",
                                                       report::significant(widening, 2))
                                         : "");
    if (&model == &reference_model(study) && study.models.size() > 1)
        sentence += " This is the most complete model.";
    return {finding, sentence};
}

std::string off(double ratio) {
    return fmt::format("{} % too {}", report::significant(100 * std::abs(ratio - 1), 2),
                       ratio > 1 ? "high" : "low");
}

/// Null if none has this property of MeasurementModel.
template <class Property>
const IdentifiedModel* most_complete(const IdentificationStudy& study, const Property& property) {
    for (const MeasurementModel& model : io::measurement_models() | std::views::reverse) {
        if (!std::invoke(property, model)) continue;
        const auto found = std::ranges::find(study.models, model.name, &IdentifiedModel::name);
        if (found != study.models.end()) return &*found;
    }
    return nullptr;
}

/// What the model that knows less makes of E.
std::optional<Verdict> bias(const IdentificationStudy& study) {
    const IdentifiedModel& reference = reference_model(study);
    const auto half_space = half_space_of(study);
    const auto k = reference.found.find(young_key);
    if (half_space == study.models.end() || &*half_space == &reference || !k) return {};
    const std::size_t i = *half_space->found.find(young_key);
    const double of_half_space = half_space->found.parameters[i].value,
                 of_layer = reference.found.parameters[*k].value, ratio = of_half_space / of_layer;
    if (std::abs(ratio - 1) < least_bias)
        return Verdict{holds, fmt::format("The half-space finds E within {:.1f} % of {}.",
                                          100 * least_bias, reference.name)};
    std::string sentence = fmt::format(
        "The half-space finds E = {}, {} {}: ", report::quantity(of_half_space, "Pa", 3),
        reference.name, report::quantity(of_layer, "Pa", 3));
    if (overlap(*half_space, reference, young_key))
        return Verdict{
            not_resolved,
            sentence + "their intervals overlap; the measurement does not resolve the difference."};
    std::string effect = "E " + off(ratio);
    sentence += off(ratio);
    if (study.thickness_ratio)
        sentence += fmt::format("; the layer is {} contact widths thick",
                                report::significant(*study.thickness_ratio, 2));
    const auto mu = half_space->found.find(friction_key),
               other = reference.found.find(friction_key);
    if (mu && other && !overlap(*half_space, reference, friction_key)) {
        const std::string of_mu =
            off(half_space->found.parameters[*mu].value / reference.found.parameters[*other].value);
        sentence += "; its mu is " + of_mu;
        effect += ", mu " + of_mu;
    }
    return Verdict{.standing = violated,
                   .sentence = sentence + ".",
                   .subject = "half-space",
                   .number = fmt::format("E = {}, {} {}", report::quantity(of_half_space, "Pa", 3),
                                         reference.name, report::quantity(of_layer, "Pa", 3)),
                   .threshold = "their intervals",
                   .effect = effect};
}

/// What linear elasticity of the layer makes of E, beside fem at finite strains.
std::optional<Verdict> bias_of_small_strains(const IdentificationStudy& study) {
    if (study.input.rig.law == contact::Case::Law::linear) return {};
    const IdentifiedModel* fem = most_complete(
        study, [](const MeasurementModel& model) { return model.kind().sees_finite_strains; });
    const IdentifiedModel* linear = most_complete(study, [](const MeasurementModel& model) {
        return model.is_layer && !model.kind().sees_finite_strains;
    });
    if (!fem || !linear) return {};
    const auto k = fem->found.find(young_key), i = linear->found.find(young_key);
    if (!k || !i) return {};
    const double finite = fem->found.parameters[*k].value,
                 small = linear->found.parameters[*i].value;
    const std::string sentence =
        fmt::format("At small strains {} finds E = {}, {} at finite ones {}: ", linear->name,
                    report::quantity(small, "Pa", 3), fem->name, report::quantity(finite, "Pa", 3));
    if (overlap(*linear, *fem, young_key))
        return Verdict{holds, sentence + "no more apart than these data resolve."};
    return Verdict{violated, sentence + off(small / finite) + '.'};
}

/// Of the tables whose errors are known.
Verdict explains(const IdentifiedModel& model) {
    const auto [squares, degrees] = chi_squared(model);
    const bool good = !is_rejected(model);
    return {.standing = good ? pass : fail,
            .sentence = fmt::format(
                "{} {} the measurement: chi^2 = {} with {:.4g} degrees of freedom, {} by "
                "chance.",
                model.name, good ? "explains" : "does not explain", report::significant(squares, 3),
                degrees, report::p_value(*model.found.goodness)),
            .subject = model.name + " explains the measurement",
            .number = fmt::format("χ² = {}, {:.4g} degrees of freedom, {}",
                                  report::significant(squares, 3), degrees,
                                  report::p_value(*model.found.goodness)),
            .threshold = rejection_text(),
            .effect = good ? "" : "its values do not count"};
}

/// A fit that looks good is no proof of the half-space.
std::optional<Verdict> fit_tells_nothing(const IdentificationStudy& study) {
    const auto good = [](const IdentifiedModel& m) {
        return m.found.goodness && !is_rejected(m) && !m.found.has_pattern();
    };
    const auto biased = bias(study);
    if (study.models.size() < 2 || !biased || biased->standing != violated ||
        !std::ranges::all_of(study.models, good))
        return {};
    return Verdict{not_resolved,
                   "The measurement alone does not show which model is right: all of them pass "
                   "through it. The thickness of the layer decides."};
}

}  // namespace

std::vector<IdentifiedModel>::const_iterator half_space_of(const IdentificationStudy& study) {
    return std::ranges::find_if(study.models, [](const IdentifiedModel& model) {
        const MeasurementModel* kind = io::find_measurement_model(model.name);
        return kind && !kind->is_layer;
    });
}

const IdentifiedModel& reference_model(const IdentificationStudy& study) {
    const auto* model = most_complete(study, &MeasurementModel::is_layer);
    return model ? *model : study.models.front();  // the half-space alone
}

std::string shown(const IdentifiedModel& model, std::size_t k) {
    const FreeParameter& p = model.found.free[k];
    const auto [low, high] = full_interval(model, k);
    const bool is_open_below = low <= p.low && p.scale != FreeParameter::Scale::reciprocal;
    const bool is_open_above = high >= p.high;
    if (is_open_above && is_open_below) return "not identifiable";
    if (is_open_above && std::isinf(high)) return "above " + p.shown(low);
    if (is_open_below) return "below " + p.shown(high);
    return p.shown(model.found.parameters[k].value, low, high);
}

double input_standard_error(const IdentifiedModel& model, std::size_t k) {
    std::vector<std::string> keys;
    std::vector<double> changes;
    for (const InputContribution& input : model.contributions) {
        keys.push_back(input.key);
        changes.push_back(input.change[k]);
    }
    return std::sqrt(statistics::combined_variance(changes, model.correlations.of(keys)));
}

double combined_standard_error(const IdentifiedModel& model, std::size_t k) {
    return std::hypot(model.found.parameters[k].standard_error, input_standard_error(model, k));
}

Interval full_interval(const IdentifiedModel& model, std::size_t k) {
    const ParameterEstimate& estimate = model.found.parameters[k];
    const FreeParameter& p = model.found.free[k];
    const double half =
        statistics::normal_quantile(model.found.confidence) * input_standard_error(model, k);
    const auto [low, high] = estimate.likelihood;
    const double above = estimate.value + std::hypot(high - estimate.value, half);
    const double below = estimate.value - std::hypot(estimate.value - low, half);
    const bool is_bounded = p.scale == FreeParameter::Scale::linear ||
                            (p.scale == FreeParameter::Scale::from_zero && high <= p.high);
    return {p.scale == FreeParameter::Scale::either_sign ? below : std::max(0., below),
            is_bounded ? std::min(above, p.high) : above};
}

std::vector<Verdict> identification_verdicts(const IdentificationStudy& study) {
    std::vector<Verdict> verdicts;
    const IdentifiedModel& reference = reference_model(study);
    verdicts.push_back(values_found(study, reference));
    std::ranges::move(loop_verdicts(study), std::back_inserter(verdicts));
    std::ranges::move(law_verdicts(study), std::back_inserter(verdicts));
    std::ranges::move(interface_verdicts(study), std::back_inserter(verdicts));
    if (auto verdict = bias(study)) verdicts.push_back(std::move(*verdict));
    if (auto verdict = bias_of_small_strains(study)) verdicts.push_back(std::move(*verdict));
    for (const IdentifiedModel& model : study.models) {
        if (model.found.goodness) verdicts.push_back(explains(model));
        std::ranges::move(residual_verdicts(study, model), std::back_inserter(verdicts));
        std::ranges::move(identifiability_verdicts(model), std::back_inserter(verdicts));
    }
    if (auto verdict = untested_independence(reference)) verdicts.push_back(std::move(*verdict));
    if (auto verdict = left_out_adhesion(study)) verdicts.push_back(std::move(*verdict));
    if (auto verdict = regime_of_adhesion(study)) verdicts.push_back(std::move(*verdict));
    if (auto verdict = range_of_adhesion(study)) verdicts.push_back(std::move(*verdict));
    if (auto verdict = fit_tells_nothing(study)) verdicts.push_back(std::move(*verdict));
    if (auto verdict = model_to_use(study)) verdicts.push_back(std::move(*verdict));
    return verdicts;
}

}  // namespace tricontact::experiments

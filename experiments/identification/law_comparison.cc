#include "experiments/identification/law_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "experiments/identification/friction_values.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/identification_report.h"
#include "experiments/identification/law_remainder.h"
#include "experiments/identification/likelihood.h"
#include "experiments/identification/row_weights.h"
#include "io/case/measurement_models.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

using io::MeasurementLaw;
using Measurement = IdentificationInput::Measurement;

bool is_on_layer(const LawComparison& comparison) {
    return io::measurement_model(comparison.model).is_layer;
}

void add_nested(LawComparison& comparison) {
    for (LawFit& fit : comparison.laws)
        for (const LawFit& wider : comparison.laws) {
            if (!wider.law->contains(*fit.law)) continue;
            const double ratio =
                std::max(0., fit.minus_two_log_likelihood - wider.minus_two_log_likelihood);
            const int n_more = wider.n_fitted - fit.n_fitted;
            fit.wider.push_back(
                {wider.law, ratio, chance_of_ratio(ratio, n_more, wider.input, wider.found)});
        }
}

/// "AICc 23.4 above that of shear-strength".
void exclude(LawComparison& comparison) {
    const LawFit& least = *std::ranges::min_element(comparison.laws, {}, &LawFit::aicc);
    for (LawFit& fit : comparison.laws) {
        fit.aicc_difference = std::isfinite(fit.aicc) ? fit.aicc - least.aicc : contact::undefined;
        const auto test = std::ranges::min_element(fit.wider, {}, &NestedTest::chance);
        const double n_tests = static_cast<double>(fit.wider.size());
        if (test != fit.wider.end() && test->chance * n_tests < excluded_chance)
            fit.why_excluded = fmt::format("likelihood ratio {} beside {}, {}",
                                           report::significant(test->likelihood_ratio, 3),
                                           test->wider->name, report::p_value(test->chance));
        else if (fit.aicc_difference > excluded_aicc)
            fit.why_excluded =
                fmt::format("AICc {} above that of {}", report::significant(fit.aicc_difference, 3),
                            least.law->name);
        else if (fit.found.goodness && *fit.found.goodness < excluded_chance)
            fit.why_excluded = "chi^2, " + report::p_value(*fit.found.goodness);
        else if (!fit.found.goodness && fit.found.has_strong_pattern())
            fit.why_excluded = "its residuals show a pattern";
    }
}

void name(LawComparison& comparison, const contact::ModelRunner& runner) {
    const auto supported = comparison.supported();
    for (const std::size_t i : supported) {
        LawFit& fit = comparison.laws[i];
        bool is_told = true;
        for (const std::size_t k : supported) {
            const LawFit& other = comparison.laws[k];
            if (k == i) continue;
            if (!other.law->contains(*fit.law)) {
                is_told = false;
                continue;
            }
            const std::string left = what_is_left(comparison.model, fit, other, runner);
            if (left.empty()) continue;
            fit.not_told_from += (fit.not_told_from.empty() ? "" : "; ") + left;
            is_told = false;
        }
        if (is_told) comparison.named = i;
    }
    double least = contact::infinity;
    for (std::size_t i = 0; i < comparison.laws.size(); ++i) {
        const bool counts = supported.empty() || !comparison.laws[i].is_excluded();
        if (counts && comparison.laws[i].aicc < least) {
            least = comparison.laws[i].aicc;
            comparison.best = i;
        }
    }
    if (comparison.named) comparison.best = *comparison.named;
}

/// Errors of rows of loops as the law of most numbers leaves them, the same for all laws.
IdentificationInput with_weighed_rows(IdentificationInput input,
                                      const std::vector<std::string>& laws,
                                      const contact::ModelRunner& runner) {
    if (!input.find(Measurement::friction_loop)) return input;
    const std::string& widest = *std::ranges::max_element(
        laws, {}, [](const std::string& law) { return io::measurement_law(law).n_numbers(); });
    IdentificationInput under = with_law(input, io::measurement_law(widest));
    weigh_rows(under, runner);
    input.tables = std::move(under.tables);
    return input;
}

double largest_held_share(bool on_layer, const LawFit& fit) {
    double share = 0;
    const contact::Case rig = rig_with(fit.input, fit.found.free, fit.found.best()).as_case;
    for (const auto* shifts : fit.input.all(Measurement::static_shift))
        for (const LoadedRows& load : rows_by_load(*shifts, rig, shifts->given))
            share = std::max(share, std::ranges::max(load.given) /
                                        sliding_forces(on_layer, rig, {load.normal_force}).front());
    return share;
}

}  // namespace

std::vector<std::size_t> LawComparison::supported() const {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < laws.size(); ++i)
        if (!laws[i].is_excluded()) places.push_back(i);
    return places;
}

LawComparison compare_laws(const IdentificationInput& given, const std::vector<std::string>& laws,
                           const contact::ModelRunner& runner, const std::string& model) {
    LawComparison comparison{.model = model};
    const IdentificationInput input = with_weighed_rows(given, laws, runner);
    for (const MeasurementLaw& law : io::measurement_laws()) {
        if (!std::ranges::count(laws, law.name)) continue;
        LawFit fit{.law = &law, .input = with_law(input, law)};
        fit.input.shifts_by_theory = true;
        IdentificationTask task = task_of(fit.input, model);
        task.model = prediction_of(model, fit.input, runner);
        fit.found = identify(task);
        fit.largest_held_share = largest_held_share(is_on_layer(comparison), fit);
        const Likelihood likelihood = likelihood_of(fit.input, fit.found);
        fit.n_fitted = likelihood.n_fitted;
        fit.minus_two_log_likelihood = likelihood.minus_two_log;
        fit.aicc = likelihood.aicc;
        comparison.laws.push_back(std::move(fit));
    }
    add_nested(comparison);
    exclude(comparison);
    name(comparison, runner);
    return comparison;
}

}  // namespace tricontact::experiments

#include "experiments/predictions/record_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/models/model_kind.h"
#include "experiments/identification/identification_models.h"
#include "experiments/predictions/found_numbers.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

constexpr double largest_correlation = 1 - 1e-6;

/// What of a case the tables may tell beside friction.
void check_found(const IdentificationInput& tables) {
    tables.rig.refuse_extras("predictions of records");
    constexpr std::array<std::string_view, 3> numbers{"substrate.young", "substrate.poisson",
                                                      "indenter.radius"};
    for (const FreeParameter& p : tables.parameters)
        if (!std::ranges::count(numbers, p.key))
            throw contact::InputError(
                fmt::format("{}: measurement.find: {} is found by tricontact identify; under laws "
                            "of friction records need substrate.young, substrate.poisson or "
                            "indenter.radius alone",
                            tables.name, p.key));
    if (tables.rig.layer.thickness)
        throw contact::InputError(
            tables.name +
            ": substrate.thickness: laws of friction are compared by closed forms of the "
            "half-space; omit it, or give one law in [friction] and leave measurement.laws out");
}

/// The case's own uncertain numbers, and those that the tables tell in place of what it states.
ExperimentInput input_under(const LawFit& fit, const ExperimentInput& input,
                            const std::vector<std::string>& overrides) {
    const io::RigFile rig = io::read_rig_file(*input.case_file, overrides);
    ExperimentInput under = input;
    under.uncertain = rig.uncertain_of_case();
    under.correlations = rig.correlations;
    std::erase_if(under.uncertain, [&](const io::UncertainKey& one) {
        return fit.found.find(std::string(one.key->path)).has_value();
    });
    for (std::size_t k = 0; k < fit.found.free.size(); ++k) {
        io::UncertainKey one{.key = io::find_key(fit.found.free[k].key),
                             .number = {},
                             .place = std::string(key_of(fit.input.tables.front().measurement))};
        one.number.value = fit.found.parameters[k];
        under.uncertain.push_back(std::move(one));
        for (std::size_t i = 0; i < k; ++i)
            if (const auto r = fit.found.correlation(i, k))
                under.correlations.add(fit.found.free[i].key, fit.found.free[k].key,
                                       std::clamp(*r, -largest_correlation, largest_correlation));
    }
    return under;
}

void add_limits(RecordedLaw& law) {
    const ExperimentEvaluation& e = *law.evaluation;
    if (e.kind != Experiment::Kind::limit || !e.limit_amplitude || !e.normalised) return;
    law.measured_limit = e.limit_amplitude->at_95;
    const Estimate& limit = e.normalised->exact_limit_amplitude;
    law.predicted_limit = statistics::with_interval(limit.value, limit.standard_error,
                                                    statistics::normal_quantile(.95));
}

RecordedLaw law_of(const LawFit& fit, const ExperimentEvaluation& record,
                   const ExperimentInput& input, const PredictionRuns& runs) {
    RecordedLaw law;
    law.overrides =
        overrides_of(rig_with(fit.input, fit.found.free, fit.found.best()).as_case, fit.found);
    law.why_not = why_untold(fit);
    if (!law.why_not.empty()) return law;
    PredictionRuns under{runs.runner, runs.overrides, [&](const std::string& line) {
                             runs.say(fmt::format("{}: {}", fit.law->name, line));
                         }};
    under.overrides.insert(under.overrides.end(), law.overrides.begin(), law.overrides.end());
    ExperimentEvaluation evaluation = record;
    try {
        add_predictions(evaluation, input_under(fit, input, under.overrides), under);
    } catch (const contact::InputError& error) {
        law.why_not = error.what();  // under this law it slides
        return law;
    }
    law.evaluation = std::move(evaluation);
    add_limits(law);
    return law;
}

/// Not by the record if a law that this one contains, with one of its numbers at an end, is not.
bool contains_one_that_agrees(const RecordLaws& laws, std::size_t i) {
    for (std::size_t k = 0; k < laws.laws.size(); ++k)
        if (laws.tables.laws[i].law->contains(*laws.tables.laws[k].law) &&
            laws.laws[k].differs() == false)
            return true;
    return false;
}

std::optional<bool> differs_in(const RecordLaws& laws, std::size_t i) {
    if (const auto own = laws.laws[i].differs()) return own;
    const auto end = laws.end_of(i);
    return end ? laws.laws[*end].differs() : std::nullopt;
}

}  // namespace

std::optional<bool> RecordedLaw::differs() const {
    if (measured_limit)
        return predicted_limit->low > measured_limit->high ||
               predicted_limit->high < measured_limit->low;
    if (!evaluation || evaluation->series.empty()) return {};
    std::vector<std::optional<bool>> of_models;
    for (const SeriesDeviation& one : evaluation->series)
        if (!is_of_springs(one.model)) of_models.push_back(one.differs());
    if (of_models.empty())
        for (const SeriesDeviation& one : evaluation->series)
            of_models.push_back(static_deviation(*evaluation, one.model).differs());
    for (const std::optional<bool> answer : {std::optional(false), std::optional<bool>()})
        if (std::ranges::count(of_models, answer)) return answer;
    return true;
}

bool is_of_springs(const std::string& model) {
    return contact::model_kind(model).is_on_line();
}

const Deviation& static_deviation(const ExperimentEvaluation& e, const std::string& model) {
    return *std::ranges::find(e.deviations, model, &Deviation::model);  // the first of a model
}

std::vector<std::size_t> RecordLaws::supported() const {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < laws.size(); ++i)
        if (!laws[i].is_excluded()) places.push_back(i);
    return places;
}

std::optional<std::size_t> RecordLaws::end_of(std::size_t law) const {
    const LawFit& wide = tables.laws[law];
    std::optional<std::size_t> nearest;
    if (!is_at_an_end(wide) || has_largest_exponent(wide)) return nearest;
    double least = contact::infinity;
    for (std::size_t k = 0; k < laws.size(); ++k) {
        const LawFit& narrow = tables.laws[k];
        const double apart =
            std::abs(narrow.minus_two_log_likelihood - wide.minus_two_log_likelihood);
        if (!wide.law->contains(*narrow.law) || !(apart < least)) continue;
        nearest = k;
        least = apart;
    }
    return nearest;
}

void judge(RecordLaws& laws) {
    for (std::size_t i = 0; i < laws.laws.size(); ++i) {
        RecordedLaw& law = laws.laws[i];
        law.why_excluded = laws.tables.laws[i].why_excluded;
        if (!law.is_excluded() && differs_in(laws, i) == true && !contains_one_that_agrees(laws, i))
            law.why_excluded = "the record";
    }
    const auto left = laws.supported();
    laws.named.reset();
    if (left.size() == 1)
        laws.named = left.front();
    else if (laws.tables.named && std::ranges::count(left, *laws.tables.named))
        laws.named = laws.tables.named;
    laws.best = laws.tables.best;
    if (!left.empty())
        laws.best = *std::ranges::min_element(
            left, {}, [&](std::size_t i) { return laws.tables.laws[i].aicc; });
    if (laws.named) laws.best = *laws.named;
    if (const auto end = laws.end_of(laws.best)) laws.best = *end;
}

RecordLaws compare_record_laws(const ExperimentEvaluation& record, const ExperimentInput& input,
                               const PredictionRuns& runs) {
    const IdentificationInput tables = read_identification(*input.case_file, runs.overrides);
    check_found(tables);
    runs.say("laws of friction by the tables");
    RecordLaws laws{.tables = compare_laws(tables, tables.laws, runs.runner)};
    for (const LawFit& fit : laws.tables.laws)
        laws.laws.push_back(law_of(fit, record, input, runs));
    judge(laws);
    if (!laws.best_law().evaluation)
        throw contact::InputError(fmt::format(
            "{}: measurement.laws: under {} nothing is computed: "
            "{}; compare further laws, or measure more",
            *input.case_file, laws.tables.laws[laws.best].law->name, laws.best_law().why_not));
    return laws;
}

}  // namespace tricontact::experiments

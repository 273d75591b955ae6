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

constexpr double least_goodness = 0.01;

/// What one standard error of an input does to a parameter, relative.
double relative_change(const IdentifiedModel& model, const std::string& key, std::size_t k) {
    const auto input = std::ranges::find(model.contributions, key, &InputContribution::key);
    if (input == model.contributions.end()) return 0;
    return input->change[k] / model.found.free[k].unit_of_change(model.found.parameters[k].value);
}

/// Standard error of a parameter of one model over that of the other by the errors of the inputs,
/// which are the same for both.
double shared_error(const IdentifiedModel& a, std::size_t of_a, const IdentifiedModel& b,
                    std::size_t of_b) {
    std::set<std::string> all;
    for (const IdentifiedModel* model : {&a, &b})
        for (const InputContribution& input : model->contributions) all.insert(input.key);
    const std::vector<std::string> keys(all.begin(), all.end());
    std::vector<double> changes;
    for (const std::string& key : keys)
        changes.push_back(relative_change(a, key, of_a) - relative_change(b, key, of_b));
    return std::sqrt(statistics::combined_variance(changes, a.correlations.of(keys)));
}

/// By how much the simpler model's values differ from those of the reference, "E by 3.1 %".
std::string largest_difference(const IdentifiedModel& model, const IdentifiedModel& reference) {
    double largest = -1;
    std::string text;
    for (std::size_t k = 0; k < model.found.free.size(); ++k) {
        const FreeParameter& p = model.found.free[k];
        const auto other = reference.found.find(p.key, p.index);
        if (!other) continue;
        const double difference = std::abs(
            model.found.parameters[k].value / reference.found.parameters[*other].value - 1);
        if (difference <= largest) continue;
        largest = difference;
        text = fmt::format("{} by {} %", p.symbol, report::significant(100 * difference, 2));
    }
    return text;
}

/// Whether it finds all that the reference does, and nothing else within its intervals.
bool agrees(const IdentifiedModel& model, const IdentifiedModel& reference) {
    return model.found.free.size() == reference.found.free.size() &&
           std::ranges::all_of(model.found.free, [&](const FreeParameter& p) {
               return overlap(model, reference, p.key, p.index);
           });
}

/// Without stated errors a pattern shows what chi^2 would. Beside stated ones that chi^2 finds
/// large enough, it shows that they are correlated.
bool is_misfit(const IdentifiedModel& model) {
    return !model.found.goodness && model.found.has_strong_pattern();
}

/// What the model passed, before the full stop.
std::string with_what_test(const IdentifiedModel& model) {
    if (model.found.goodness)
        return model.found.has_pattern()
                   ? ", with intervals that errors of neighbouring rows widen."
                   : ".";
    return ", the most complete of these models. Without stated errors no model is tested but by "
           "the pattern of its residuals, and those of " +
           model.name +
           (model.found.has_pattern() ? " have one that 5 % of tables have by chance."
                                      : " have none.");
}

}  // namespace

bool overlap(const IdentifiedModel& a, const IdentifiedModel& b, const std::string& key,
             std::size_t index) {
    // Of the likelihood, or no further apart than the inputs' errors move one model's value against
    // the other's.
    const auto of_a = a.found.find(key, index), of_b = b.found.find(key, index);
    if (!of_a || !of_b) return false;
    const Interval i = a.found.parameters[*of_a].likelihood,
                   k = b.found.parameters[*of_b].likelihood;
    const double gap = std::max(i.low - k.high, k.low - i.high);
    const double reach =
        statistics::normal_quantile(a.found.confidence) * shared_error(a, *of_a, b, *of_b);
    return gap <= reach * b.found.free[*of_b].unit_of_change(b.found.parameters[*of_b].value);
}

bool is_rejected(const IdentifiedModel& model) {
    return model.found.goodness && *model.found.goodness < least_goodness;
}

ChiSquared chi_squared(const IdentifiedModel& model) {
    ChiSquared result;
    for (const TableFit& table : model.found.tables)
        if (table.goodness) {
            result.sum += table.sum_of_squares;
            result.degrees += table.degrees_of_freedom;
        }
    return result;
}

std::string rejection_text() {
    return "p at least " + report::significant(least_goodness, 2);
}

std::optional<Verdict> model_to_use(const IdentificationStudy& study) {
    const IdentifiedModel& reference = reference_model(study);
    if (study.models.size() < 2) {
        // Laws that were compared say it themselves; chi^2 of stated errors does, too.
        if (!is_misfit(reference) || !study.input.laws.empty()) return {};
        return Verdict{fail,
                       "The values of " + reference.name +
                           " are not to be used before the reason is known: its residuals show a "
                           "pattern that independent errors leave in less than 1 of 100 tables."};
    }
    if (is_rejected(reference))
        return Verdict{fail, fmt::format("None of the values is to be used before the reason is "
                                         "known: chi^2 rejects {}, the most complete model.",
                                         reference.name)};
    if (is_misfit(reference))
        return Verdict{fail,
                       "None of the values is to be used before the reason is known: the "
                       "residuals of " +
                           reference.name + ", the most complete model, show a pattern."};
    const auto half_space = half_space_of(study);
    if (half_space == study.models.end() || &*half_space == &reference)
        return Verdict{finding, "Use the values of " + reference.name + with_what_test(reference)};
    if (is_misfit(*half_space))
        return Verdict{finding, fmt::format("Use the values of {}: the residuals of the half-space "
                                            "show a pattern.",
                                            reference.name)};
    if (is_rejected(*half_space))
        return Verdict{finding, fmt::format("Use the values of {}: chi^2 rejects the half-space.",
                                            reference.name)};
    const std::string difference = largest_difference(*half_space, reference);
    if (agrees(*half_space, reference))
        return Verdict{finding,
                       fmt::format("The half-space suffices: its values differ from those of {} "
                                   "({}) by no more than these data resolve.",
                                   reference.name, difference)};
    if (difference.empty() || half_space->found.free.size() != reference.found.free.size())
        return Verdict{
            finding,
            fmt::format("Use the values of {}: the half-space has no thickness.", reference.name)};
    return Verdict{finding,
                   fmt::format("Use the values of {}: those of the half-space differ ({}) by more "
                               "than these data resolve.",
                               reference.name, difference)};
}

}  // namespace tricontact::experiments

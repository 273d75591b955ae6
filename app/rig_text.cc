#include <fmt/format.h>

#include "app/rig_report.h"
#include "comparisons/format.h"

namespace tricontact::app {

namespace {

constexpr int digits = 4;

// Prefixes do not suit units that have one.
comparisons::Unit unit_for(double value, const std::string& unit) {
    if (unit == "1") return {1, ""};
    if (unit.starts_with("kg")) return {1, unit};
    return comparisons::fitting_unit(value, unit);
}

}  // namespace

std::string text_of(const theory::Uncertain& value, const std::string& unit) {
    const comparisons::Unit fitting = unit_for(value.value, unit);
    const double number = value.value / fitting.factor;
    std::string text = value.standard_error > 0
                           ? comparisons::with_error(number, value.standard_error / fitting.factor)
                           : comparisons::significant(number, digits);
    if (!fitting.symbol.empty()) text += ' ' + fitting.symbol;
    return text;
}

std::string given_text(const rig::Calculation& calculation) {
    std::string text;
    for (const rig::Given& one : calculation.given) {
        const comparisons::Unit fitting = unit_for(one.value.value, one.unit);
        std::string number = comparisons::as_given(one.value.value / fitting.factor);
        if (one.value.standard_error > 0)
            number += " ± " + comparisons::as_given(one.value.standard_error / fitting.factor);
        if (!fitting.symbol.empty()) number += ' ' + fitting.symbol;
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", one.symbol, number);
    }
    return text;
}

std::string arithmetic(const rig::Calculation& calculation) {
    return fmt::format("{} = {} = {}, with {}", calculation.symbol, calculation.formula,
                       text_of(calculation.result, calculation.unit), given_text(calculation));
}

std::string threshold_text(const rig::Criterion& criterion) {
    const char* relation =
        criterion.relation == rig::Criterion::Relation::at_most ? "at most" : "at least";
    return fmt::format("{} {}", relation, comparisons::as_given(criterion.threshold));
}

const char* word_of(rig::Standing standing) {
    constexpr const char* words[] = {"holds", "fails", "cannot tell"};
    return words[static_cast<int>(standing)];
}

const char* word_of(rig::PrintedCheck::Agreement agreement) {
    constexpr const char* words[] = {"agrees", "within its error", "differs", "not computed"};
    return words[static_cast<int>(agreement)];
}

std::string substitutes_text(const rig::PrintedCheck& check) {
    std::string text;
    for (const rig::Substitute& one : check.substitutes)
        text += fmt::format("{}{} = {} instead of {}", text.empty() ? "" : "; ", one.symbol,
                            text_of({one.needed}, one.unit), text_of({one.given}, one.unit));
    return text;
}

std::string error_text(const rig::PrintedCheck& check) {
    if (!check.error_ratio || check.error_agrees) return "";
    return fmt::format("the printed error is {} times the propagated one",
                       comparisons::significant(*check.error_ratio, 3));
}

}  // namespace tricontact::app

#include <fmt/format.h>

#include <cmath>

#include "experiments/rig_report/rig_report.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

constexpr int digits = 4;

// Prefixes do not suit units that have one.
report::Unit unit_for(double value, const std::string& unit) {
    if (unit == "1") return {1, ""};
    if (unit.starts_with("kg")) return {1, unit};
    return report::fitting_unit(value, unit);
}

// The modulus of an indenter that the case takes as rigid.
bool is_rigid(const Estimate& value, const std::string& unit) {
    return unit == "Pa" && value.value >= rigid_young;
}

}  // namespace

std::string text_of(const Estimate& value, const std::string& unit) {
    if (is_rigid(value, unit)) return "infinite";
    const report::Unit fitting = unit_for(value.value, unit);
    const double number = value.value / fitting.factor;
    std::string text = value.standard_error > 0
                           ? report::with_error(number, value.standard_error / fitting.factor)
                           : report::significant(number, digits);
    if (!fitting.symbol.empty()) text += ' ' + fitting.symbol;
    return text;
}

std::string given_text(const Calculation& calculation) {
    std::string text;
    for (const Given& one : calculation.given) {
        const report::Unit fitting = unit_for(one.value.value, one.unit);
        std::string number = is_rigid(one.value, one.unit)
                                 ? "infinite"
                                 : report::as_given(one.value.value / fitting.factor);
        if (one.value.standard_error > 0)
            number += " ± " + report::as_given(one.value.standard_error / fitting.factor);
        if (!fitting.symbol.empty() && !is_rigid(one.value, one.unit))
            number += ' ' + fitting.symbol;
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", one.symbol, number);
    }
    return text;
}

std::string arithmetic(const Calculation& calculation) {
    return fmt::format("{} = {} = {}, with {}", calculation.symbol, calculation.formula,
                       text_of(calculation.result, calculation.unit), given_text(calculation));
}

std::string threshold_text(const Criterion& criterion) {
    const char* relation =
        criterion.relation == Criterion::Relation::at_most ? "at most" : "at least";
    return fmt::format("{} {}", relation, report::as_given(criterion.threshold));
}

const char* word_of(PrintedCheck::Agreement agreement) {
    constexpr const char* words[] = {"agrees", "within its error", "differs", "not computed"};
    return words[static_cast<int>(agreement)];
}

std::string substitutes_text(const PrintedCheck& check) {
    std::string text;
    for (const Substitute& one : check.substitutes)
        text += fmt::format("{}{} = {} instead of {}", text.empty() ? "" : "; ", one.symbol,
                            text_of({one.needed}, one.unit), text_of({one.given}, one.unit));
    return text;
}

std::string text_of(const MeasuredEffect& effect) {
    const double percent = 100 * effect.relative.value,
                 error = 100 * effect.relative.standard_error;
    if (effect.is_bound && std::isinf(effect.relative.value))
        return fmt::format("not bounded (at F_T = {} mu F_N the contact might slide)",
                           coupling_tangential_ratio);
    if (effect.is_bound) return fmt::format("at most {} %", report::significant(percent, 2));
    const std::string size = error > 0 ? report::with_error(std::abs(percent), error, 3)
                                       : report::significant(std::abs(percent), 3);
    return fmt::format("{}{} %", percent < 0 ? "−" : "+", size);
}

std::string effects_text(const RigReport& report, const std::string& assumption) {
    std::string text;
    for (const MeasuredEffect& one : report.effects)
        if (one.assumption == assumption)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name_of(one.measured),
                                text_of(one));
    return text;
}

std::string error_text(const PrintedCheck& check) {
    if (!check.error_ratio || check.error_agrees) return "";
    return fmt::format("the printed error is {} times the propagated one",
                       report::significant(*check.error_ratio, 3));
}

}  // namespace tricontact::experiments

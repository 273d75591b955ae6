// What residuals show, in sentences.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/identification/estimation/residual_checks.h"
#include "experiments/identification/identification_report.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

using report::Verdict;
using enum Verdict::Standing;

// Intervals that may be wider by less than this hardly depend on what is assumed of the errors.
constexpr double notable_widening = 1.3;

std::string pattern_sentence(const IdentifiedModel& model, const TableResiduals& one,
                             const std::string& table) {
    std::string reasons;
    const auto& correlation = *one.correlation;
    if (one.lack_of_fit && *one.lack_of_fit < rare_chance)
        reasons = fmt::format(
            "its curve misses the readings by more than repeated ones scatter "
            "(lack of fit, {})",
            report::p_value(*one.lack_of_fit));
    // What has no correlation has its pattern from repeated readings alone.
    if (reasons.empty() || correlation.of_errors > 0)
        reasons += fmt::format(
            "{}neighbouring residuals correlate by {} ({} for independent "
            "errors)",
            reasons.empty() ? "" : "; ", report::significant(correlation.lag_one, 2),
            report::p_value(correlation.chance));
    return fmt::format(
        "{}: the residuals of {} show a pattern: {}. Either errors of neighbouring "
        "rows are correlated, or the model leaves something out: the intervals "
        "include such a correlation, but no error of the model.",
        model.name, table, reasons);
}

/// "row 7 of static-shift (tangential force F_T = 8.79 N)".
std::string place_of(const IdentificationInput& input, std::size_t row) {
    std::size_t t = 0;
    while (row >= input.tables[t].observed.size()) row -= input.tables[t++].observed.size();
    const auto& table = input.tables[t];
    const MeasuredColumn& given = columns_of(table.measurement).given;
    return fmt::format("row {} of {} ({} = {})", row + 1, name_of(table), given.axis,
                       report::given_quantity(table.given[row], std::string(given.unit)));
}

/// "E = 4.20 MPa, mu = 0.570", without some of the rows.
std::string values_changed(const Identification& found, const std::vector<double>& change) {
    std::string values;
    for (std::size_t k = 0; k < found.free.size(); ++k) {
        const FreeParameter& p = found.free[k];
        const double value =
            std::clamp(p.changed(found.parameters[k].value, change[k]), p.low, p.high);
        values += fmt::format("{}{} = {}", k == 0 ? "" : ", ", p.symbol, p.shown(value));
    }
    return values;
}

Verdict outlying_verdict(const IdentificationStudy& study, const IdentifiedModel& model,
                         const std::vector<statistics::OutlyingRow>& rows) {
    std::string places;
    for (const statistics::OutlyingRow& one : rows)
        places += fmt::format("{}{}, {} standard errors {} what the other rows give ({} by chance)",
                              places.empty() ? "" : "; ", place_of(study.input, one.row),
                              report::significant(std::abs(one.deviation), 2),
                              one.deviation > 0 ? "above" : "below", report::p_value(one.chance));
    const bool is_one = rows.size() == 1;
    return {fail,
            fmt::format("{}: {} an outlier: {}. Without {}: {}. Check {} before the values "
                        "are used.",
                        model.name, is_one ? "one row is" : "each of these rows is", places,
                        is_one ? "it" : "them", values_changed(model.found, rows.back().change),
                        is_one ? "this reading" : "these readings")};
}

}  // namespace

std::vector<Verdict> residual_verdicts(const IdentificationStudy& study,
                                       const IdentifiedModel& model) {
    std::vector<Verdict> verdicts;
    // What a rejected model leaves has a pattern: it is said that it does not explain the rows.
    for (std::size_t t = 0; t < model.found.residuals.size() && !is_rejected(model); ++t) {
        const TableResiduals& one = model.found.residuals[t];
        if (one.has_pattern)
            verdicts.push_back({one.has_strong_one ? fail : not_resolved,
                                pattern_sentence(model, one, name_of(study.input.tables[t]))});
    }
    // Rows far off a rejected model are its misfit where another one explains them.
    const bool is_misfit = is_rejected(model) && !std::ranges::all_of(study.models, &is_rejected);
    if (!model.found.outlying.empty() && !is_misfit)
        verdicts.push_back(outlying_verdict(study, model, model.found.outlying));
    return verdicts;
}

std::optional<Verdict> untested_independence(const IdentifiedModel& model) {
    const Identification& found = model.found;
    if (found.has_pattern() || found.possible_widening < notable_widening) return {};
    double largest = 0;
    for (const TableResiduals& one : found.residuals)
        if (one.correlation) largest = std::max(largest, one.correlation->not_excluded);
    return Verdict{
        not_resolved,
        fmt::format("Errors of different rows are assumed to be independent. The residuals of {} "
                    "do not exclude a correlation of up to {} between neighbouring rows, which "
                    "would make its intervals up to {} times as wide.",
                    model.name, report::significant(largest, 2),
                    report::significant(found.possible_widening, 2))};
}

}  // namespace tricontact::experiments

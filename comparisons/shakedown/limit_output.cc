// Limits of shakedown as files and on a terminal.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparisons/shakedown/limit.h"
#include "report/json_table.h"
#include "report/table_text.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

json run_json(const LimitRun& run) {
    return {{"value", run.value},
            {quantities::state.key, contact::name_of(run.state)},
            {quantities::periods.key, run.periods},
            {quantities::final_shift.key, run.final_shift},
            {quantities::final_shift_ratio.key, run.final_shift_ratio}};
}

json to_json(const ModelLimit& m) {
    const auto shift = m.shift_ratio();
    return {{"limit", m.bracket.centre()},
            {"last_shakedown", m.bracket.last_shakedown},
            {"first_ratcheting", m.bracket.first_ratcheting},
            {"undecided", m.bracket.undecided},
            {"limit_by_pressures", m.by_pressures},
            {"exact_uncoupled_limit", m.exact},
            {"final_shift_ratio_at_limit",
             shift ? json{{"value", shift->value}, {"low", shift->low}, {"high", shift->high}}
                   : json()},
            {"coupled", m.coupled},
            {"periods_at_most", m.periods_at_most},
            {quantities::border_force_share.key, m.border_force_share},
            {"runs", report::list_of(m.runs, run_json)}};
}

/// What the table and limit.csv have of each model.
json rows_of(const LimitStudy& study) {
    return report::list_of(study.models, [&](const ModelLimit& m) {
        json row = to_json(m);
        const auto [value, low, high] = m.shift_ratio().value_or(BracketedValue{NAN, NAN, NAN});
        row.update({{"model", m.model},
                    {"limit_of", study.varied().key},
                    {"half_width", m.bracket.half_width()},
                    {"final_shift_ratio_at_limit", value},
                    {"final_shift_ratio_low", low},
                    {"final_shift_ratio_high", high},
                    {"final_shift_ratio_error", value - low}});
        return row;
    });
}

/// Significant digits of a ratio below 1 that show the width of the narrowest bracket.
int bracket_digits(const LimitStudy& study) {
    double narrowest = 0.1;
    for (const ModelLimit& m : study.models)
        if (m.bracket.half_width() > 0) narrowest = std::min(narrowest, m.bracket.half_width());
    return std::clamp(static_cast<int>(std::ceil(-std::log10(narrowest))) + 1, 3, 8);
}

}  // namespace

json limit_json(const std::string& version, const LimitStudy& study) {
    json models = json::object();
    for (const ModelLimit& m : study.models) models[m.model] = to_json(m);
    return {{"version", version},
            {"limit_of", study.varied().key},
            {study.fixed().key, study.given},
            {"thesis", study.thesis},
            {"models", models}};
}

std::string limit_csv(const LimitStudy& study) {
    return report::csv_of(rows_of(study), {"model", "limit_of", "limit", "last_shakedown",
                                           "first_ratcheting", "limit_by_pressures",
                                           "exact_uncoupled_limit", "final_shift_ratio_at_limit",
                                           "final_shift_ratio_low", "final_shift_ratio_high"});
}

report::DocumentTable limit_table(const LimitStudy& study) {
    const auto bracket = [digits = bracket_digits(study)](const char* name) {
        return fmt::format("{}:{}", name, digits);
    };
    report::DocumentTable table = report::table_of(
        {.id = "limits",
         .title = fmt::format("Limits in {}", study.varied().symbol),
         .note =
             "limit: middle of the bracket and its half width, of the model at its resolution. "
             "by pressures: where (1/F_N) ∫ min p dA over the path is f_T, the exact limit of "
             "uncoupled contact at the same resolution. exact: the same of the continuous body, "
             "Hertz' that of the half-space, 1 - 3/2 w + 1/2 w³ of a paraboloid, or the exact "
             "layer. u at the limit: shift over U_max where the first ratcheting run was slowest, "
             "its error the distance to the last shakedown."},
        rows_of(study),
        {{"model", "model"},
         {"limit", bracket("limit"), 1, "half_width"},
         {"last_shakedown", bracket("last shakedown")},
         {"first_ratcheting", bracket("first ratcheting")},
         {"limit_by_pressures", bracket("by pressures")},
         {"exact_uncoupled_limit", bracket("exact, uncoupled")},
         {"final_shift_ratio_at_limit", "u at the limit:4", 1, "final_shift_ratio_error"}});
    if (!study.thesis) return table;
    table.rows.push_back({"thesis", *study.thesis});
    table.rows.back().resize(table.columns.size(), report::number_cell({}));
    return table;
}

report::DocumentTable limit_run_table(const LimitStudy& study) {
    json rows = json::array();
    for (const ModelLimit& m : study.models)
        for (const LimitRun& run : m.runs) {
            rows.push_back(run_json(run));
            rows.back()["model"] = m.model;
        }
    return report::table_of(
        {.id = "runs",
         .title = "All runs",
         .note = "Shift after the last period, in micrometres and over each model's own U_max."},
        rows,
        {{"model", "model"},
         {"value", study.varied().symbol + std::string(":8")},
         {quantities::state.key, "verdict"},
         {quantities::periods.key, "periods"},
         {quantities::final_shift.key, "U [µm]:5", 1e-6},
         {quantities::final_shift_ratio.key, "u [U_max]:5"}});
}

std::string limit_text(const LimitStudy& study) {
    return fmt::format("limit of shakedown in {} at {} = {:.6g}\n", study.varied().symbol,
                       study.fixed().symbol, study.given) +
           report::table_text(limit_table(study));
}

}  // namespace tricontact::comparisons

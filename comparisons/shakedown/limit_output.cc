#include <fmt/format.h>

#include "comparisons/shakedown/limit.h"
#include "report/fields.h"
#include "report/format.h"
#include "report/table_text.h"

namespace tricontact::comparisons {

namespace {

using Json = nlohmann::ordered_json;
using enum report::In;

report::Fields<LimitRun, ModelLimit> run_fields(const LimitStudy& study) {
    return {{"", "model", [](auto&, auto& m) { return report::display_name(m.model); }},
            {"value", study.varied().symbol + std::string(":8"), &LimitRun::value},
            {quantities::state.key, "verdict", [](auto& r) { return contact::name_of(r.state); }},
            {quantities::periods.key, "periods", &LimitRun::periods},
            {quantities::final_shift.key, "U [µm]:5", &LimitRun::final_shift, 1e-6},
            {quantities::final_shift_ratio.key, "u [U_max]:5", &LimitRun::final_shift_ratio}};
}

/// NaN where unknown.
BracketedValue shift_at(const ModelLimit& m) {
    return m.shift_ratio().value_or(BracketedValue{NAN, NAN, NAN});
}

Json shift_json(const ModelLimit& m) {
    const auto shift = m.shift_ratio();
    if (!shift) return nullptr;
    return {{"value", shift->value}, {"low", shift->low}, {"high", shift->high}};
}

report::Fields<ModelLimit, LimitStudy> model_fields() {
    return {
        {"model", [](auto& m) { return m.model; }, csv},
        {"", "model", [](auto& m) { return report::display_name(m.model); }},
        {"limit_of", [](auto&, auto& study) { return study.varied().key; }, csv},
        {"limit", "limit:7", [](auto& m) { return m.bracket.centre(); }, 1,
         [](auto& m) { return m.bracket.half_width(); }},
        {"last_shakedown", "last shakedown:8", [](auto& m) { return m.bracket.last_shakedown; }},
        {"first_ratcheting", "first ratcheting:8",
         [](auto& m) { return m.bracket.first_ratcheting; }},
        {"undecided", [](auto& m) { return m.bracket.undecided; }, json},
        {"limit_by_pressures", "by pressures:8", [](auto& m) { return m.by_pressures; }},
        {"exact_uncoupled_limit", "exact, uncoupled:8", [](auto& m) { return m.exact; }},
        {"final_shift_ratio_at_limit", [](auto& m) { return shift_json(m); }, json},
        {"final_shift_ratio_at_limit", "u at the limit:4",
         [](auto& m) { return shift_at(m).value; }, 1,
         [](auto& m) { return shift_at(m).value - shift_at(m).low; }, csv},
        {"final_shift_ratio_low", [](auto& m) { return shift_at(m).low; }, csv},
        {"final_shift_ratio_high", [](auto& m) { return shift_at(m).high; }, csv},
        {"coupled", [](auto& m) { return m.coupled; }, json},
        {"periods_at_most", [](auto& m) { return m.periods_at_most; }, json},
        {quantities::border_force_share.key, [](auto& m) { return m.border_force_share; }, json},
        {"runs",
         [](auto& m, auto& study) {
             const auto fields = run_fields(study);
             return report::list_of(m.runs, [&](auto& r) { return report::json_of(fields, r, m); });
         },
         json}};
}

}  // namespace

Json limit_json(const std::string& version, const LimitStudy& study) {
    Json models = Json::object();
    for (const ModelLimit& m : study.models)
        models[m.model] = report::json_of(model_fields(), m, study);
    return {{"version", version},
            {"limit_of", study.varied().key},
            {study.fixed().key, study.given},
            {"thesis", study.thesis},
            {"models", models}};
}

std::string limit_csv(const LimitStudy& study) {
    return report::csv_of(model_fields(), study.models, study);
}

report::DocumentTable limit_table(const LimitStudy& study) {
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
        model_fields(), study.models, study);
    if (!study.thesis) return table;
    table.rows.push_back({"thesis", *study.thesis});
    table.rows.back().resize(table.columns.size(), report::number_cell({}));
    return table;
}

report::DocumentTable limit_run_table(const LimitStudy& study) {
    report::DocumentTable table{
        .id = "runs",
        .title = "All runs",
        .note = "Shift after the last period, in micrometres and over each model's own U_max."};
    const auto fields = run_fields(study);
    report::add_columns(table, fields);
    for (const ModelLimit& m : study.models)
        for (const LimitRun& run : m.runs) report::add_row(table, fields, run, m);
    return table;
}

std::string limit_text(const LimitStudy& study) {
    return fmt::format("limit of shakedown in {} at {} = {:.6g}\n", study.varied().symbol,
                       study.fixed().symbol, study.given) +
           report::table_text(limit_table(study));
}

}  // namespace tricontact::comparisons

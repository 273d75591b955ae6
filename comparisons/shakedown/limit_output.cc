// Limits of shakedown as files and on a terminal.

#include <fmt/format.h>

#include <cmath>

#include "comparisons/shakedown/limit.h"
#include "report/csv.h"
#include "report/format.h"
#include "report/json_number.h"

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
    std::string text = report::csv_line({"model", "limit_of", "limit", "last_shakedown",
                                         "first_ratcheting", "limit_by_pressures",
                                         "exact_uncoupled_limit", "final_shift_ratio_at_limit",
                                         "final_shift_ratio_low", "final_shift_ratio_high"});
    for (const ModelLimit& m : study.models) {
        const auto [value, low, high] = m.shift_ratio().value_or(BracketedValue{NAN, NAN, NAN});
        text += report::csv_row(m.model, study.varied().key, m.bracket.centre(),
                                m.bracket.last_shakedown, m.bracket.first_ratcheting,
                                m.by_pressures, m.exact, value, low, high);
    }
    return text;
}

std::string limit_text(const LimitStudy& study) {
    std::string text =
        fmt::format("limit of shakedown in {} at {} = {:.6g}\n{:<10} {:>11} {:>11} {:>11} {:>11}\n",
                    study.varied().symbol, study.fixed().symbol, study.given, "", "shakes down",
                    "ratchets", "pressures", "exact");
    for (const ModelLimit& m : study.models)
        text += fmt::format("{:<10} {:>11.7g} {:>11.7g} {:>11.7g} {:>11}\n", m.model,
                            m.bracket.last_shakedown, m.bracket.first_ratcheting, m.by_pressures,
                            m.exact ? fmt::format("{:.7g}", *m.exact) : "-");
    if (study.thesis) text += fmt::format("{:<10} {:>23.7g}\n", "thesis", *study.thesis);
    return text;
}

}  // namespace tricontact::comparisons

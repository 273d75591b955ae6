#include <nlohmann/json.hpp>

#include "experiments/rig_report/rig_report.h"
#include "files/version.h"
#include "report/json_number.h"

namespace tricontact::experiments {

using json = nlohmann::ordered_json;

static json quantity_json(const Estimate& quantity, const std::string& unit) {
    return {{"value", quantity.value}, {"standard_error", quantity.standard_error}, {"unit", unit}};
}

static void to_json(json& to, const Calculation& calculation) {
    json given = json::object();
    for (const Given& one : calculation.given)
        given[one.symbol] = quantity_json(one.value, one.unit);
    to = {{"name", calculation.name},
          {"symbol", calculation.symbol},
          {"formula", calculation.formula},
          {"source", calculation.source},
          {"given", std::move(given)},
          {"result", quantity_json(calculation.result, calculation.unit)}};
}

static void to_json(json& to, const Criterion& criterion) {
    to = criterion.calculation;
    to["threshold"] = threshold_text(criterion);
    to["reason"] = criterion.reason;
    to["standing"] = word_of(criterion.standing());
    if (criterion.probability_violated)
        to["probability_violated"] = report::number(criterion.probability_violated);
}

static void to_json(json& to, const Assumption& assumption) {
    to = {{"name", assumption.name},
          {"title", assumption.title},
          {"claim", assumption.claim},
          {"standing", word_of(assumption.standing())},
          {"consequence", assumption.consequence},
          {"missing", assumption.missing},
          {"criteria", assumption.criteria},
          {"background", assumption.background}};
}

static void to_json(json& to, const Substitute& one) {
    to = {{"symbol", one.symbol}, {"needed", one.needed}, {"given", one.given}, {"unit", one.unit}};
}

static void to_json(json& to, const PrintedCheck& check) {
    to = {{"name", check.printed.name},
          {"printed", check.printed.text},
          {"source", check.printed.source},
          {"computed", check.calculation},
          {"agreement", word_of(check.agreement)},
          {"printed_over_computed", check.calculation ? json(check.ratio) : json()},
          {"printed_error_over_propagated", check.error_ratio},
          {"errors_agree", check.error_ratio ? json(check.error_agrees) : json()},
          {"follows_from", check.substitutes}};
}

static void to_json(json& to, const MeasuredEffect& effect) {
    to = {{"assumption", effect.assumption},
          {"measured", name_of(effect.measured)},
          {"relative", effect.relative.value},
          {"standard_error", effect.relative.standard_error},
          {"is_bound", effect.is_bound}};
}

std::string rig_json(const RigReport& report) {
    const json all = {{"version", files::version},
                      {"title", report.title},
                      {"assumptions", report.assumptions},
                      {"effects", report.effects},
                      {"printed", report.printed}};
    return all.dump(2) + '\n';
}

}  // namespace tricontact::experiments

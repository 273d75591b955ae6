#include <nlohmann/json.hpp>

#include "experiments/assumptions/rig_report.h"
#include "files/version.h"
#include "report/json_number.h"

namespace tricontact::experiments {

namespace {

using report::number;
using json = nlohmann::ordered_json;

json quantity_json(const Estimate& quantity, const std::string& unit) {
    return {{"value", number(quantity.value)},
            {"standard_error", number(quantity.standard_error)},
            {"unit", unit}};
}

json calculation_json(const Calculation& calculation) {
    json given = json::object();
    for (const Given& one : calculation.given)
        given[one.symbol] = quantity_json(one.value, one.unit);
    return {{"name", calculation.name},
            {"symbol", calculation.symbol},
            {"formula", calculation.formula},
            {"source", calculation.source},
            {"given", std::move(given)},
            {"result", quantity_json(calculation.result, calculation.unit)}};
}

json criterion_json(const Criterion& criterion) {
    json result = calculation_json(criterion.calculation);
    result["threshold"] = threshold_text(criterion);
    result["reason"] = criterion.reason;
    result["standing"] = word_of(criterion.standing());
    return result;
}

json assumption_json(const Assumption& assumption) {
    json criteria = json::array(), background = json::array();
    for (const auto& one : assumption.criteria) criteria.push_back(criterion_json(one));
    for (const auto& one : assumption.background) background.push_back(calculation_json(one));
    return {{"name", assumption.name},
            {"title", assumption.title},
            {"claim", assumption.claim},
            {"standing", word_of(assumption.standing())},
            {"consequence", assumption.consequence},
            {"missing", assumption.missing},
            {"criteria", std::move(criteria)},
            {"background", std::move(background)}};
}

json printed_json(const PrintedCheck& check) {
    json substitutes = json::array();
    for (const Substitute& one : check.substitutes)
        substitutes.push_back({{"symbol", one.symbol},
                               {"needed", number(one.needed)},
                               {"given", number(one.given)},
                               {"unit", one.unit}});
    return {{"name", check.printed.name},
            {"printed", check.printed.text},
            {"source", check.printed.source},
            {"computed", check.calculation ? calculation_json(*check.calculation) : json()},
            {"agreement", word_of(check.agreement)},
            {"printed_over_computed", check.calculation ? number(check.ratio) : json()},
            {"printed_error_over_propagated", number(check.error_ratio)},
            {"errors_agree", check.error_ratio ? json(check.error_agrees) : json()},
            {"follows_from", std::move(substitutes)}};
}

}  // namespace

std::string rig_json(const RigReport& report) {
    json assumptions = json::array(), printed = json::array();
    for (const auto& one : report.assumptions) assumptions.push_back(assumption_json(one));
    for (const auto& one : report.printed) printed.push_back(printed_json(one));
    const json all = {{"version", files::version},
                      {"title", report.title},
                      {"assumptions", std::move(assumptions)},
                      {"printed", std::move(printed)}};
    return all.dump(2) + '\n';
}

}  // namespace tricontact::experiments

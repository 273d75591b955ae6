#include "comparisons/quantities/results.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/reference.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using json = nlohmann::ordered_json;

json to_json(const QuantityValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* count = std::get_if<int>(&value)) return *count;
    if (const auto* state = std::get_if<State>(&value)) return contact::name_of(*state);
    if (const auto* regime = std::get_if<SlipRegime>(&value)) return name_of(*regime);
    if (const auto* list = std::get_if<Numbers>(&value)) return report::numbers(*list);
    return nullptr;
}

QuantityValue value_of(const json& stored) {
    if (stored.is_number_integer()) return stored.get<int>();
    if (stored.is_number()) return stored.get<double>();
    if (!stored.is_string()) return {};
    for (const State state :
         {State::shakedown, State::cyclic_slip, State::ratcheting, State::undecided})
        if (stored == contact::name_of(state)) return state;
    for (const SlipRegime regime :
         {SlipRegime::stick, SlipRegime::partial_slip, SlipRegime::gross_slip, SlipRegime::mixed})
        if (stored == name_of(regime)) return regime;
    return {};
}

/// Every quantity in its place, undefined ones as null; an object whose members are all undefined
/// is null.
json results_json(const Results& results) {
    json object = json::object();
    for (const Quantity* q : all_quantities())
        object[json::json_pointer(q->place ? q->place : std::string("/") + q->key)] =
            to_json(results[*q]);
    for (json& member : object)
        if (member.is_object() && std::ranges::all_of(member, &json::is_null)) member = nullptr;
    json& audit = object["audit"] = json::object();
    for (const auto& check : results.audit)
        audit[check.name] = {{"worst", report::number(check.worst)},
                             {"allowed", report::number(check.allowed)},
                             {"passed", check.passed()}};
    return object;
}

}  // namespace

Results::Results(const contact::Case& c, const contact::History& history)
    : model(history.model), verdict(history.verdict), audit(history.audit.checks()) {
    const Subject subject{c, history};
    for (const Quantity* q : all_quantities()) set(*q, q->of(subject));
}

const QuantityValue& Results::operator[](const Quantity& q) const {
    static const QuantityValue undefined;
    const QuantityValue* value = found(values_, &q);
    return value ? *value : undefined;
}

std::optional<double> Results::number(const Quantity& q) const {
    const QuantityValue& value = (*this)[q];
    if (const auto* count = std::get_if<int>(&value)) return *count;
    return number_of(value);
}

std::optional<double> Results::told(const Quantity& q) const {
    return !q.told_in || state() == q.told_in ? number(q) : std::nullopt;
}

const Numbers& Results::list(const Quantity& q) const {
    static const Numbers none;
    const auto* list = std::get_if<Numbers>(&(*this)[q]);
    return list ? *list : none;
}

std::optional<State> Results::state() const {
    const auto* state = std::get_if<State>(&(*this)[quantities::state]);
    return state ? std::optional(*state) : std::nullopt;
}

bool is_pressed_alone(const Results& results) {
    const auto is_little = [&results](const Quantity& ratio) {
        return !is_loaded(results.number(ratio).value_or(0));
    };
    return !results.state() && is_little(quantities::tangential_ratio) &&
           is_little(quantities::final_shift_ratio);
}

int Results::periods() const {
    return static_cast<int>(number(quantities::periods).value_or(0));
}

void Results::set(const Quantity& q, QuantityValue value) {
    values_[&q] = std::move(value);
}

std::vector<const Quantity*> column_quantities() {
    std::vector<const Quantity*> columns;
    std::ranges::copy_if(all_quantities(), std::back_inserter(columns), &Quantity::is_column);
    return columns;
}

json stored_results(const Results& results) {
    json stored = json::object();
    for (const Quantity* q : column_quantities()) stored[q->key] = to_json(results[*q]);
    return stored;
}

Results read_stored_results(const json& stored) {
    Results results;
    for (const Quantity* q : column_quantities())
        if (const auto found = stored.find(q->key); found != stored.end())
            results.set(*q, value_of(*found));
    return results;
}

std::string summary_json(const std::string& version, const json& resolved_case,
                         const std::vector<Results>& results, const json& sections) {
    json models = json::object();
    for (const Results& of_model : results) models[of_model.model] = results_json(of_model);
    json document{{"version", version}, {"case", resolved_case}, {"models", models}};
    for (const auto& [name, section] : sections.items())
        if (!section.empty()) document[name] = section;
    return document.dump(2) + "\n";
}

std::string summary_json(const std::string& version, const json& resolved_case,
                         const std::vector<Results>& results) {
    return summary_json(version, resolved_case, results, json::object());
}

}  // namespace tricontact::comparisons

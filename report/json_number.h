#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

// What is written to JSON, which has no infinities: their text is null, as that of NaN.

/// Null where empty.
template <class Value>
struct nlohmann::adl_serializer<std::optional<Value>> {
    template <class Json>
    static void to_json(Json& json, const std::optional<Value>& value) {
        json = value ? Json(*value) : Json();
    }
};

namespace tricontact::report {

/// A number in JSON: null where undefined or not finite.
inline nlohmann::ordered_json number(std::optional<double> value) {
    if (!value || !std::isfinite(*value)) return nullptr;
    return *value;
}

/// Rounded to that many significant digits: fewer bytes of text.
double to_digits(double value, int digits);

/// A list of what `json_of` makes of each value.
template <class Values, class JsonOf>
nlohmann::ordered_json list_of(const Values& values, const JsonOf& json_of) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& value : values) list.push_back(json_of(value));
    return list;
}

/// A list of such numbers, of doubles or optional ones.
template <class Values>
nlohmann::ordered_json numbers(const Values& values) {
    return list_of(values, number);
}

}  // namespace tricontact::report

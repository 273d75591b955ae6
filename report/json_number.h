#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace tricontact::report {

/// A number in JSON, which has no infinities: null where undefined or not finite.
inline nlohmann::ordered_json number(std::optional<double> value) {
    if (!value || !std::isfinite(*value)) return nullptr;
    return *value;
}

/// A list of such numbers, of doubles or optional ones.
template <class Values>
nlohmann::ordered_json numbers(const Values& values) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& value : values) list.push_back(number(value));
    return list;
}

}  // namespace tricontact::report

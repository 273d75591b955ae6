#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace tricontact::comparisons {

/// A number in JSON, which has no infinities: null where undefined or not finite.
inline nlohmann::ordered_json number(std::optional<double> value) {
    if (!value || !std::isfinite(*value)) return nullptr;
    return *value;
}

}  // namespace tricontact::comparisons

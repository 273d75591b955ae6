#include "comparisons/quantities/quantity.h"

#include <cmath>

#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons {

QuantityValue finite(std::optional<double> value) {
    if (value && std::isfinite(*value)) return *value;
    return {};
}

std::optional<double> number_of(const QuantityValue& value) {
    const auto* number = std::get_if<double>(&value);
    return number ? std::optional(*number) : std::nullopt;
}

std::span<const Quantity* const> all_quantities() {
    static const std::vector<const Quantity*> all = [] {
        std::vector<const Quantity*> list;
        using namespace quantities;
        for (const auto& part :
             {of_contact(), of_shift(), of_limit(), of_mapping(), of_dissipation(), of_loop(),
              of_jumps(), of_relaxation(), of_roller(), of_subsurface(), of_strength(), of_strain(),
              of_end_of_run(), of_cost()})
            list.insert(list.end(), part.begin(), part.end());
        return list;
    }();
    return all;
}

std::string label_of(const Quantity& q) {
    const std::string symbol = q.symbol;
    return symbol.empty() ? q.name : q.name + (" " + symbol);
}

std::string ratio_key(const Quantity& q) {
    const std::string key = q.key;
    std::string suffix = std::string("_") + q.unit;
    if (const auto slash = suffix.find('/'); slash != std::string::npos)
        suffix.replace(slash, 1, "_per_");
    return *q.unit && key.ends_with(suffix) ? key.substr(0, key.size() - suffix.size()) : key;
}

std::string unit_of(const Quantity& q) {
    const std::string unit = q.unit, over = q.over;
    return !unit.empty() ? unit : over.empty() ? "1" : over;
}

std::string heading_of(const Quantity& q) {
    return std::string(q.symbol) + " [" + unit_of(q) + "]";
}

}  // namespace tricontact::comparisons

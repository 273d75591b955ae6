#include "comparisons/quantities/quantity.h"

#include <algorithm>
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
             {of_contact(), of_shift(), of_limit(), of_mapping(), of_dissipation(), of_relaxation(),
              of_roller(), of_subsurface(), of_cost()})
            list.insert(list.end(), part.begin(), part.end());
        return list;
    }();
    return all;
}

const Quantity* find_quantity(std::string_view key) {
    const auto all = all_quantities();
    const auto found =
        std::ranges::find(all, key, [](const Quantity* q) { return std::string_view(q->key); });
    return found == all.end() ? nullptr : *found;
}

std::string label_of(const Quantity& q) {
    const std::string symbol = q.symbol;
    return symbol.empty() ? q.name : q.name + (" " + symbol);
}

std::string ratio_key(const Quantity& q) {
    const std::string key = q.key, unit = q.unit;
    const auto slash = unit.find('/');
    const std::string suffix = '_' + (slash == std::string::npos ? unit
                                                                 : unit.substr(0, slash) + "_per_" +
                                                                       unit.substr(slash + 1));
    return !unit.empty() && key.ends_with(suffix) ? key.substr(0, key.size() - suffix.size()) : key;
}

std::string heading_of(const Quantity& q) {
    const std::string unit = q.unit, over = q.over;
    return std::string(q.symbol) + " [" + (!unit.empty() ? unit : over.empty() ? "1" : over) + "]";
}

}  // namespace tricontact::comparisons

#include "report/derived_value.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/format.h"

namespace tricontact::report {

std::string derived_lines(const std::vector<DerivedValue>& values) {
    std::string text;
    for (const DerivedValue& one : values) {
        const bool pure = one.unit == "1";
        const Unit unit = pure ? Unit{1, "-"} : fitting_unit(one.value, one.unit);
        text += fmt::format("# {:<8} = {:>12} {:<4} {}\n", one.symbol,
                            significant(one.value / unit.factor), unit.symbol, one.meaning);
    }
    return text;
}

nlohmann::ordered_json derived_json(const std::vector<DerivedValue>& values) {
    nlohmann::ordered_json all = nlohmann::ordered_json::object();
    for (const DerivedValue& one : values)
        all[one.symbol] = {{"value", one.value}, {"unit", one.unit}, {"meaning", one.meaning}};
    return all;
}

}  // namespace tricontact::report

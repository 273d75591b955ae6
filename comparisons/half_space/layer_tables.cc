#include <algorithm>

#include "comparisons/half_space/layer_report.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using Value = std::optional<double>;

Value ratio(Value value, Value base) {
    return value && base && *base != 0 ? Value(*value / *base) : Value();
}

report::Unit common_unit(const PressedQuantity& q, const LayerComparison& layer) {
    double largest = q.get(layer.half_space).value_or(0);
    for (const auto& model : layer.models)
        largest = std::max(largest, q.get(model.values).value_or(0));
    return report::fitting_unit(largest, q.quantity->unit);
}

}  // namespace

Table layer_table(const LayerComparison& layer) {
    Table table{"Pressed contact on the layer", {}, {{}}};
    if (layer.exact) table.columns = {"exact layer"};
    table.columns.emplace_back("half-space");
    for (const auto& model : layer.models)
        table.columns.push_back(report::display_name(model.name));
    if (layer.exact) {
        table.columns.emplace_back("half-space vs exact");
        for (const auto& model : layer.models)
            table.columns.push_back(report::display_name(model.name) + " vs exact");
    }
    for (const PressedQuantity& q : pressed_quantities()) {
        const report::Unit unit = common_unit(q, layer);
        Table::Row row{report::typeset(label_of(*q.quantity)), unit.symbol, {}};
        const auto add = [&](const PressedValues& values) {
            const Value value = q.get(values);
            row.cells.push_back(report::significant(value ? Value(*value / unit.factor) : Value()));
        };
        const auto compare = [&](const PressedValues& values) {
            row.cells.push_back(report::percent(ratio(q.get(values), q.get(*layer.exact))));
        };
        if (layer.exact) add(*layer.exact);
        add(layer.half_space);
        for (const auto& model : layer.models) add(model.values);
        if (layer.exact) {
            compare(layer.half_space);
            for (const auto& model : layer.models) compare(model.values);
        }
        table.groups.front().rows.push_back(row);
    }
    return table;
}

}  // namespace tricontact::comparisons

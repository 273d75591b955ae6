#include <algorithm>

#include "comparisons/half_space/layer_report.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using Value = std::optional<double>;

report::Unit common_unit(const PressedQuantity& q, const LayerComparison& layer) {
    double largest = q.get(layer.half_space).value_or(0);
    for (const auto& model : layer.models)
        largest = std::max(largest, q.get(model.values).value_or(0));
    return report::fitting_unit(largest, q.quantity->unit);
}

}  // namespace

report::DocumentTable layer_table(const LayerComparison& layer) {
    report::DocumentTable table{
        .id = "layer", .title = "Pressed contact on the layer", .columns = quantity_columns()};
    const auto name_of = [](const auto& model) { return report::display_name(model.name); };
    if (layer.exact) table.columns.push_back({"exact layer"});
    table.columns.push_back({"half-space"});
    for (const auto& model : layer.models) table.columns.push_back({name_of(model)});
    if (layer.exact) {
        table.columns.push_back(change_column("half-space", "exact"));
        for (const auto& model : layer.models)
            table.columns.push_back(change_column(name_of(model), "exact"));
    }
    for (const PressedQuantity& q : pressed_quantities()) {
        const report::Unit unit = common_unit(q, layer);
        std::vector<report::Cell> row{label_of(*q.quantity), unit.symbol};
        const auto add = [&](const PressedValues& values) {
            const Value value = q.get(values);
            row.push_back(report::number_cell(value ? Value(*value / unit.factor) : Value()));
        };
        const auto compare = [&](const PressedValues& values) {
            row.push_back(change_cell(q.get(values), q.get(*layer.exact)));
        };
        if (layer.exact) add(*layer.exact);
        add(layer.half_space);
        for (const auto& model : layer.models) add(model.values);
        if (layer.exact) {
            compare(layer.half_space);
            for (const auto& model : layer.models) compare(model.values);
        }
        table.rows.push_back(row);
    }
    return table;
}

}  // namespace tricontact::comparisons

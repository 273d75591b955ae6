// The layer's section of summary.json.

#include <nlohmann/json.hpp>

#include "comparisons/half_space/layer_report.h"
#include "report/json_number.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using json = nlohmann::ordered_json;

json values_json(const PressedValues& values) {
    json result = json::object();
    for (const PressedQuantity& q : pressed_quantities())
        result[q.quantity->key] = report::number(q.get(values));
    return result;
}

/// Ratio minus 1 of each quantity.
json difference_json(const PressedValues& values, const std::optional<PressedValues>& base) {
    if (!base) return nullptr;
    json result = json::object();
    for (const PressedQuantity& q : pressed_quantities()) {
        const auto value = q.get(values), reference = q.get(*base);
        result[ratio_key(*q.quantity)] =
            value && reference ? json(*value / *reference - 1) : json();
    }
    return result;
}

json apparent_json(const std::optional<ApparentModuli>& apparent) {
    if (!apparent) return nullptr;
    return {{"from_indentation", report::number(apparent->from_indentation)},
            {"from_contact_radius", report::number(apparent->from_contact_radius)},
            {"from_unit_shift", report::number(apparent->from_unit_shift)}};
}

json models_json(const LayerComparison& layer) {
    json result = json::object();
    for (const auto& model : layer.models)
        result[model.name] = {{"ignores_thickness", is_half_space(model.name)},
                              {"values", values_json(model.values)},
                              {"over_exact", difference_json(model.values, layer.exact)}};
    return result;
}

json treatment_json(const Case& c) {
    const bool friction = c.load.press == Case::Press::friction;
    return {{"coupling", c.contact.coupling},
            {"press", friction ? "friction" : "frictionless"},
            {"press_steps", friction ? c.load.press_steps : 1}};
}

}  // namespace

json layer_json(const Case& c, const LayerComparison& layer) {
    return {{"thickness_m", report::number(layer.thickness)},
            {"thickness_over_hertz_diameter", report::number(layer.thickness_ratio)},
            {"half_width_over_thickness", report::number(layer.half_width)},
            {"half_depth_over_thickness", report::number(layer.half_depth)},
            {"exact", layer.exact ? values_json(*layer.exact) : json()},
            {"why_no_exact", layer.exact ? json() : json(layer.why_not)},
            {"half_space", values_json(layer.half_space)},
            {"half_space_over_exact", difference_json(layer.half_space, layer.exact)},
            {"apparent_young_Pa", apparent_json(layer.apparent)},
            {"models", models_json(layer)},
            {"contact", treatment_json(c)}};
}

}  // namespace tricontact::comparisons

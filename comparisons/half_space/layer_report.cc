#include "comparisons/half_space/layer_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/quantities/change_table.h"
#include "contact/case.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;

/// "3.19 % larger"
std::string larger(double ratio) {
    return ratio == 1 ? "equal" : report::apart(ratio, "larger", "smaller");
}

std::string ground_phrase(const Case::Layer& layer) {
    if (layer.lower.size() > 1)
        return fmt::format("and rests on {} further layers of {} together", layer.lower.size(),
                           report::given_quantity(layer.total_thickness() - *layer.thickness, "m"));
    if (!layer.lower.empty())
        return fmt::format("and rests on a second layer of {} and E = {}",
                           report::given_quantity(layer.lower.front().thickness, "m"),
                           report::given_quantity(layer.lower.front().material.young, "Pa"));
    if (layer.base == Case::Base::half_space)
        return fmt::format("and bonded to a half-space of E = {}",
                           report::given_quantity(layer.ground->young, "Pa"));
    return layer.base == Case::Base::bonded ? "and bonded to its rigid ground"
                                            : "and glides on its rigid ground";
}

std::string thickness_sentence(const Case& c, const LayerComparison& layer) {
    std::string text = fmt::format(
        "The layer is {} thick, {} times the {} of Hertz' contact, {}.",
        report::given_quantity(layer.thickness, "m"), report::significant(layer.thickness_ratio, 3),
        c.is_cylindrical() ? "width" : "diameter", ground_phrase(c.layer));
    if (!layer.exact) text += " It is compared with no exact solution: " + layer.why_not + ".";
    return text;
}

/// What ignoring the thickness does, by the exact theories of both bodies.
std::string half_space_sentence(const Case& c, const LayerComparison& layer) {
    std::vector<std::string> models;
    for (const auto& model : layer.models)
        if (is_half_space(model.name)) models.push_back(model.name);
    std::string text =
        models.empty()
            ? "A half-space model would ignore the thickness."
            : fmt::format("{} {} and ignore{} the thickness.", report::display_names(models),
                          models.size() > 1 ? "are half-space models" : "is a half-space model",
                          models.size() > 1 ? "" : "s");
    if (!layer.exact) return text;
    const PressedValues &h = layer.half_space, &e = *layer.exact;
    text += fmt::format(" That alone, at equal {}, makes ",
                        c.load.normal_force ? "force" : "indentation");
    text += c.load.normal_force
                ? fmt::format("the indentation {}", larger(h.indentation / e.indentation))
                : fmt::format("the force {}", larger(h.normal_force / e.normal_force));
    text += fmt::format(", the contact radius {}, the peak pressure {}",
                        larger(h.contact_radius / e.contact_radius),
                        larger(h.peak_pressure / e.peak_pressure));
    if (e.unit_shift && *e.unit_shift > 0)
        text += fmt::format(" and U_max {}", larger(*h.unit_shift / *e.unit_shift));
    return text + " than on the layer (exact theories of both).";
}

std::string apparent_sentence(const Case& c, const LayerComparison& layer) {
    if (!layer.apparent) return {};
    const ApparentModuli& apparent = *layer.apparent;
    return fmt::format(
        "Hertz' theory would identify on this layer E = {} from force and indentation, {} from "
        "the contact radius{}; the layer has {}.",
        report::quantity(apparent.from_indentation, "Pa", 3),
        report::quantity(apparent.from_contact_radius, "Pa", 3),
        apparent.from_unit_shift ? fmt::format(" and {} from U_max",
                                               report::quantity(*apparent.from_unit_shift, "Pa", 3))
                                 : "",
        report::given_quantity(c.substrate.young, "Pa"));
}

std::string side_text(const char* name, std::optional<double> half, std::optional<double> length) {
    if (!half) return fmt::format("its {} is unbounded", name);
    return fmt::format("{} of {} puts the sides {} thicknesses from the centre", name,
                       report::given_quantity(*length, "m"), report::significant(*half, 3));
}

std::string width_sentence(const Case& c, const LayerComparison& layer) {
    const auto sees_sides = [](const auto& model) {
        return contact::model_kind(model.name).sees_sides;
    };
    if (std::ranges::none_of(layer.models, sees_sides))
        return {};  // the others' layer is infinitely wide
    if (const auto& mesh = c.of<fem::Settings>().mesh)
        return fmt::format(
            "The block is that of {}; exact layer and half-space are infinitely wide.", *mesh);
    const double far = contact::far_sides(c);
    if (!layer.half_width && !layer.half_depth)
        return fmt::format(
            "The block is so wide that its sides are hardly felt ({} thicknesses to each side, or "
            "more); exact layer and half-space are infinitely wide.",
            far);
    std::string text = fmt::format("The block is finite: {}, {}.",
                                   side_text("width", layer.half_width, c.layer.width),
                                   side_text("depth", layer.half_depth, c.layer.depth));
    if (std::min(layer.half_width.value_or(far), layer.half_depth.value_or(far)) < far)
        text += fmt::format(
            " Less than {} may be felt; exact layer and half-space are infinitely "
            "wide and do not show by how much.",
            far);
    return text;
}

std::string layer_note(const Case& c) {
    const bool line = c.is_cylindrical();
    return std::string(
               "Pressed without friction. Exact layer: the frictionless contact of a "
               "rigid body with an infinitely wide layer on its rigid ground, ") +
           (line ? "a singular integral equation of plane strain"
                 : "a Fredholm equation in one dimension") +
           ". Half-space: " + (contact::is_hertz_round(c) ? "Hertz" : "the body's contact there") +
           ". The stiffness of half-space models is " + (line ? "πE*L/(2 ln(2L/a))" : "2 E*a") +
           ", that of others is taken from presses at 0.6, 0.8 and 1 times the load.";
}

report::Unit common_unit(const PressedQuantity& q, const LayerComparison& layer) {
    double largest = q.get(layer.half_space).value_or(0);
    for (const auto& model : layer.models)
        largest = std::max(largest, q.get(model.values).value_or(0));
    return report::fitting_unit(largest, q.quantity->unit);
}

}  // namespace

std::vector<std::string> layer_sentences(const Case& c, const LayerComparison& layer) {
    std::vector<std::string> result{thickness_sentence(c, layer), half_space_sentence(c, layer),
                                    apparent_sentence(c, layer), width_sentence(c, layer)};
    std::erase(result, "");
    return result;
}

report::DocumentTable layer_table(const Case& c, const LayerComparison& layer) {
    report::DocumentTable table{.id = "layer",
                                .title = "Pressed contact on the layer",
                                .note = layer_note(c),
                                .columns = quantity_columns()};
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
            row.push_back(report::number_cell(q.get(values), unit.factor));
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

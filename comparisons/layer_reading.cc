#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/format.h"
#include "comparisons/layer_report.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;

constexpr double negligible_beta = 1e-3;  // of Dundurs: coupling below is not felt
constexpr double wide_enough = 6;         // thicknesses from the centre to a side

std::vector<std::string> select(const std::vector<std::string>& models, bool half_space) {
    std::vector<std::string> result;
    std::copy_if(models.begin(), models.end(), std::back_inserter(result),
                 [&](const auto& model) { return is_half_space(model) == half_space; });
    return result;
}

/// "3.19 % larger"
std::string larger(double ratio) {
    return fmt::format("{} % {}", significant(100 * std::abs(ratio - 1), 3),
                       ratio > 1 ? "larger" : "smaller");
}

std::string ground_phrase(const Case::Layer& layer) {
    if (layer.lower.size() > 1)
        return fmt::format("and rests on {} further layers of {} together", layer.lower.size(),
                           given_quantity(layer.total_thickness() - *layer.thickness, "m"));
    if (!layer.lower.empty())
        return fmt::format("and rests on a second layer of {} and E = {}",
                           given_quantity(layer.lower.front().thickness, "m"),
                           given_quantity(layer.lower.front().material.young, "Pa"));
    if (layer.base == Case::Base::half_space)
        return fmt::format("and bonded to a half-space of E = {}",
                           given_quantity(layer.ground->young, "Pa"));
    return layer.base == Case::Base::bonded ? "and bonded to its rigid ground"
                                            : "and glides on its rigid ground";
}

std::string thickness_sentence(const Case& c, const LayerComparison& layer) {
    std::string text =
        fmt::format("The layer is {} thick, {} times the diameter of Hertz' contact, {}.",
                    given_quantity(layer.thickness, "m"), significant(layer.thickness_ratio, 3),
                    ground_phrase(c.layer));
    if (!layer.exact) text += " It is compared with no exact solution: " + layer.why_not + ".";
    return text;
}

/// What ignoring the thickness does, by the exact theories of both bodies.
std::string half_space_sentence(const Case& c, const LayerComparison& layer) {
    std::vector<std::string> models;
    for (const auto& model : layer.models) models.push_back(model.name);
    models = select(models, true);
    std::string text =
        models.empty()
            ? "A half-space model would ignore the thickness."
            : fmt::format("{} {} and ignore{} the thickness.", display_names(models),
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
        "the contact radius{}; the rubber has {}.",
        quantity(apparent.from_indentation, "Pa", 3),
        quantity(apparent.from_contact_radius, "Pa", 3),
        apparent.from_unit_shift
            ? fmt::format(" and {} from U_max", quantity(*apparent.from_unit_shift, "Pa", 3))
            : "",
        given_quantity(c.substrate.young, "Pa"));
}

std::string side_text(const char* name, std::optional<double> half, std::optional<double> length) {
    if (!half) return fmt::format("its {} is chosen wide enough", name);
    return fmt::format("{} of {} puts the sides {} thicknesses from the centre", name,
                       given_quantity(*length, "m"), significant(*half, 3));
}

std::string width_sentence(const Case& c, const LayerComparison& layer) {
    if (std::all_of(layer.models.begin(), layer.models.end(),
                    [](const auto& model) { return model.half_space; }))
        return {};  // none of them sees the sides
    if (c.fem.mesh)
        return fmt::format(
            "The block is that of {}; exact layer and half-space are infinitely "
            "wide.",
            *c.fem.mesh);
    if (!layer.half_width && !layer.half_depth)
        return "The block is chosen wide enough for its sides not to be felt (6 thicknesses to "
               "each side, or more); exact layer and half-space are infinitely wide.";
    std::string text = fmt::format("The block is finite: {}, {}.",
                                   side_text("width", layer.half_width, c.layer.width),
                                   side_text("depth", layer.half_depth, c.layer.depth));
    if (std::min(layer.half_width.value_or(wide_enough), layer.half_depth.value_or(wide_enough)) <
        wide_enough)
        text +=
            " Less than 6 are felt; exact layer and half-space are infinitely wide and do not "
            "tell by how much.";
    return text;
}

const StaticVariant* find(const std::vector<StaticVariant>& variants, const std::string& key) {
    const auto found = std::find_if(variants.begin(), variants.end(),
                                    [&](const StaticVariant& v) { return v.key == key; });
    return found == variants.end() ? nullptr : &*found;
}

/// What another choice would do to the static shift; empty where nobody computed it.
std::string change_text(const std::vector<StaticVariant>& variants, const std::string& key) {
    const StaticVariant* v = find(variants, key);
    if (!v) return {};
    if (!v->changed_shift)
        return fmt::format(" With {} = {} there is no number: {}.", key, v->changed, v->why_none);
    return fmt::format(" With {} = {} the static shift of {} would be {} instead of {} ({}).", key,
                       v->changed, display_name(v->model), quantity(*v->changed_shift, "m"),
                       quantity(v->static_shift, "m"), percent(v->ratio()));
}

std::string coupling_sentence(const Case& c, const std::vector<std::string>& layered,
                              const std::vector<StaticVariant>& variants) {
    if (layered.empty()) return {};
    std::string text =
        c.contact.coupling
            ? fmt::format(
                  "{} couples normal and tangential contact (contact.coupling = true): "
                  "pressure drags the surface sideways and friction lifts it.",
                  display_names(layered))
            : fmt::format(
                  "The coupling of normal and tangential contact in the layer is left out "
                  "of {} (contact.coupling = false).",
                  display_names(layered));
    return text + change_text(variants, "contact.coupling");
}

std::string half_space_coupling_sentence(const Case& c,
                                         const std::vector<std::string>& half_spaces) {
    const double beta = c.materials().dundurs_beta();
    if (half_spaces.empty()) return {};
    if (std::abs(beta) <= negligible_beta)
        return fmt::format(
            "{} {} no such coupling: on a half-space these materials have next to "
            "none (Dundurs' β = {}).",
            display_names(half_spaces), half_spaces.size() > 1 ? "have" : "has",
            significant(beta, 2));
    return fmt::format(
        "{} {} out the coupling that these materials have on a half-space: Dundurs' "
        "β = {} is not small.",
        display_names(half_spaces), half_spaces.size() > 1 ? "leave" : "leaves",
        significant(beta, 2));
}

std::string kinematics_sentence(const Case& c, const std::vector<StaticVariant>& variants) {
    const bool linear = c.contact.kinematics == Case::Kinematics::linear;
    return (linear ? std::string("Gap and normal are those of the undisplaced surface point "
                                 "(contact.kinematics = linear).")
                   : std::string("Gap and normal are taken where the surface point has moved to "
                                 "(contact.kinematics = deformed).")) +
           change_text(variants, "contact.kinematics");
}

std::string pressing_sentence(const Case& c, const std::vector<StaticVariant>& variants) {
    const std::string how = c.load.press == Case::Press::friction
                                ? fmt::format("in {} equal steps with friction", c.load.press_steps)
                                : std::string("in one step without friction");
    return fmt::format(
               "Where the two are coupled the way of pressing is remembered: here the "
               "normal load comes {}, then the tangential one.",
               how) +
           change_text(variants, "load.press");
}

}  // namespace

std::vector<std::string> layer_sentences(const Case& c, const LayerComparison& layer) {
    std::vector<std::string> result{thickness_sentence(c, layer), half_space_sentence(c, layer)};
    for (const std::string& text : {apparent_sentence(c, layer), width_sentence(c, layer)})
        if (!text.empty()) result.push_back(text);
    return result;
}

std::vector<std::string> treatment_sentences(const Case& c, const std::vector<std::string>& models,
                                             const std::vector<StaticVariant>& variants) {
    const std::vector<std::string> layered = select(models, false);
    std::vector<std::string> result{coupling_sentence(c, layered, variants),
                                    half_space_coupling_sentence(c, select(models, true))};
    const bool coupled = !variants.empty() || (!layered.empty() && c.contact.coupling) ||
                         c.contact.kinematics == Case::Kinematics::deformed;
    if (coupled) {
        result.push_back(kinematics_sentence(c, variants));
        result.push_back(pressing_sentence(c, variants));
    }
    std::erase(result, std::string());
    return result;
}

}  // namespace tricontact::comparisons

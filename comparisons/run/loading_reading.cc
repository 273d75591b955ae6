#include "comparisons/run/loading_reading.h"

#include <fmt/format.h>

#include <algorithm>

#include "comparisons/quantities/reference.h"
#include "contact/base/special_values.h"
#include "contact/models/model_kind.h"
#include "contact/substrates/normal_tangential.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::State;

/// What the change does after rolling; empty where nothing was rolled.
std::string rolled_text(const LoadingVariant& v) {
    if (!v.why_not_rolled.empty())
        return fmt::format(", after rolling it is unknown ({})", v.why_not_rolled);
    if (!v.run.state || !v.other->state) return {};
    if (!v.rolled_error())
        return fmt::format(", and the verdict {} instead of {}", contact::name_of(*v.other->state),
                           contact::name_of(*v.run.state));
    if (*v.run.state == State::ratcheting)
        return ", and the shift per period " +
               instead(v.other->increment, v.run.increment, v.rolled_error());
    return fmt::format(", and the shift after rolling {}",
                       instead(v.other->final_shift, v.run.final_shift, v.rolled_error()));
}

/// What another choice would do; empty where it was not computed.
std::string change_text(const std::vector<LoadingVariant>& variants, const std::string& key) {
    const auto v =
        std::ranges::find_if(variants, [&](const LoadingVariant& one) { return one.key == key; });
    if (v == variants.end()) return {};
    if (!v->other)
        return fmt::format(" With {} = {} there is no number: {}.", key, v->changed, v->why_none);
    return fmt::format(" With {} = {} the {} of {} would be {}{}.", key, v->changed,
                       v->loaded->name, report::display_name(v->model),
                       instead(v->loaded_value(*v->other), v->loaded_value(v->run),
                               v->loaded_error(), v->loaded->unit),
                       rolled_text(*v));
}

std::string coupling_sentence(const Case& c, const std::vector<std::string>& coupled,
                              const std::vector<LoadingVariant>& variants) {
    if (coupled.empty()) return {};
    const std::string names = report::display_names(coupled);
    std::string text =
        c.contact.coupling
            ? fmt::format(
                  "{} couple{} normal and tangential contact (contact.coupling = true): "
                  "pressure drags the surface sideways and friction lifts it.",
                  names, coupled.size() > 1 ? "" : "s")
            : fmt::format(
                  "The coupling of normal and tangential contact is left out of {} "
                  "(contact.coupling = false).",
                  names);
    return text + change_text(variants, "contact.coupling");
}

std::string uncoupled_layer_sentence(const std::vector<std::string>& models) {
    if (std::ranges::find(models, contact::ModelKind::Method::coupled_springs,
                          [](const auto& model) { return contact::model_kind(model).method; }) ==
        models.end())
        return {};
    return "MDR layer leaves out the coupling of normal and tangential contact: its springs along "
           "the line of contact move in one direction at a time.";
}

/// Half-space models that take no coupling: whether that is right for these materials.
std::string half_space_sentence(const Case& c, const std::vector<std::string>& half_spaces) {
    if (half_spaces.empty()) return {};
    const bool several = half_spaces.size() > 1;
    const std::string beta = report::significant(c.materials().dundurs_beta(), 2);
    if (!half_spaces_couple(c))
        return fmt::format(
            "{} {} no coupling: on a half-space these materials have next to none "
            "(Dundurs' β = {}).",
            report::display_names(half_spaces), several ? "have" : "has", beta);
    return fmt::format(
        "{} {} out the coupling that these materials have on a half-space: Dundurs' "
        "|β| exceeds {} (β = {}).",
        report::display_names(half_spaces), several ? "leave" : "leaves", contact::negligible_beta,
        beta);
}

std::string pressing_sentence(const Case& c, const std::vector<LoadingVariant>& variants) {
    const std::string how = c.load.press == Case::Press::friction
                                ? fmt::format("in {} equal steps with friction", c.load.press_steps)
                                : std::string("in one step without friction");
    return fmt::format(
               "Coupled contact remembers the way of pressing: here the normal load comes {}{}.",
               how, c.is_pressed_only() ? "" : ", then the tangential one") +
           change_text(variants, "load.press") + change_text(variants, "load.press_steps");
}

}  // namespace

std::string instead(std::optional<double> changed, std::optional<double> chosen,
                    std::optional<double> error, const char* unit) {
    return fmt::format("{} instead of {} ({})", report::quantity(changed.value_or(0), unit),
                       report::quantity(chosen.value_or(0), unit),
                       report::percent(error.value_or(contact::undefined) + 1));
}

std::vector<std::string> treatment_sentences(const Case& c, const std::vector<std::string>& models,
                                             const std::vector<LoadingVariant>& variants) {
    // Without coupling the models that could couple are named as such.
    Case could = c;
    could.contact.coupling = true;
    std::vector<std::string> half_spaces, coupled;
    for (const std::string& model : models) {
        if (is_uncoupled_half_space(c, model))
            half_spaces.push_back(model);
        else if (couples(could, model) && !is_tabulated(c, model))
            coupled.push_back(model);
    }
    std::vector<std::string> result{coupling_sentence(c, coupled, variants),
                                    uncoupled_layer_sentence(models),
                                    half_space_sentence(c, half_spaces)};
    // Uncoupled contact has no pressing to remember.
    const bool remembers = !coupled.empty() && c.contact.coupling;
    const bool pressed_anew = std::ranges::any_of(
        variants, [](const LoadingVariant& v) { return v.key.starts_with("load.press"); });
    if (remembers || pressed_anew) result.push_back(pressing_sentence(c, variants));
    std::erase(result, std::string());
    return result;
}

}  // namespace tricontact::comparisons

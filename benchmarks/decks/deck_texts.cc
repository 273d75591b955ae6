#include "benchmarks/decks/deck_texts.h"

#include <fmt/format.h>

#include <iterator>

namespace tricontact::benchmarks {

std::string submission_text(const DeckModel& model, const DeckFamily& family) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "case = \"{}\"\ncode = \"{}\"\nelements = \"{}\"\nblock_width = \"{:.9g} mm\"\n",
                   model.name, family.code, family.elements, model.width);
    fmt::format_to(out, "\n[contact]\nmethod = \"{}\"\nkinematics = \"{}\"\n", family.method,
                   family.kinematics);
    if (family.has_stiffness) {
        fmt::format_to(out, "stiffness = \"{:.9g} MPa/mm\"\n", model.stiffness);
        if (model.mu > 0)
            fmt::format_to(out, "stick_slope = \"{:.9g} MPa/mm\"\n", model.stick_slope);
    }
    if (model.mu > 0) fmt::format_to(out, "press_steps = {}\n", model.steps.front().increments);
    for (const DeckRun& run : family.runs) {
        fmt::format_to(out, "\n[[mesh]]\nsize = \"{:.9g} mm\"\nfield = \"{}\"\n", run.size,
                       run.field);
        if (!run.set.empty()) fmt::format_to(out, "set = \"{}\"\n", run.set);
        if (!run.totals.empty()) fmt::format_to(out, "totals = \"{}\"\n", run.totals);
    }
    return text;
}

std::string readme_text(const DeckModel& model, const DeckFamily& family) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{}: {} with {}\n", model.name, family.code, family.elements);
    for (const DeckRun& run : family.runs) fmt::format_to(out, "{}\n", run.command);
    return text;
}

}  // namespace tricontact::benchmarks

#include <fmt/format.h>

#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons {

namespace {

std::string section(const char* title, const quantities::List& list) {
    std::string text = fmt::format(
        "\n### {}\n\n| Key | Symbol | Unit | Meaning | Defined | Source |\n"
        "|---|---|---|---|---|---|\n",
        title);
    for (const Quantity* q : list)
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", q->key, q->symbol, unit_of(*q),
                            q->meaning, q->defined, q->source);
    return text;
}

}  // namespace

std::string glossary() {
    using namespace quantities;
    return section("Pressed contact and load", of_contact()) + section("Shift", of_shift()) +
           section("Limits", of_limit()) + section("Mapping", of_mapping()) +
           section("Frictional work", of_dissipation()) +
           section("Friction loops of paths", of_loop()) +
           section("Friction that changes with the way of slip", of_jumps()) +
           section("Relaxation", of_relaxation()) + section("Ends of rollers", of_roller()) +
           section("Inside of the substrate", of_subsurface()) +
           section("Strength", of_strength()) + section("Strains", of_strain()) +
           section("End of the run", of_end_of_run()) + section("Cost", of_cost()) +
           section("Of comparisons, beside runs",
                   {&tangential_stiffness, &coupled_tangential_stiffness, &shift_of_rolling});
}

std::string summary_keys() {
    std::string text = "| Key | Meaning |\n|---|---|\n";
    for (const Quantity* q : all_quantities())
        text += fmt::format("| `{}` | {} |\n", q->place ? std::string(q->place).substr(1) : q->key,
                            q->meaning);
    return text + "| `audit` | each check of all solutions with `worst`, `allowed`, `passed` |\n";
}

}  // namespace tricontact::comparisons

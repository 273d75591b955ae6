#include "contact/wearing_contact.h"
#include "io/case/case_keys.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Wear;

template <auto member>
Field of_wear(Case& c) {
    return c.kept.find<Wear>() ? Field(&(c.of<Wear>().*member)) : Field();
}

}  // namespace

std::vector<CaseKey> wear_keys() {
    constexpr double most_cycles = 1e7;
    return {
        {quantity_key("wear.coefficient", Dimension::wear_rate, above_zero(1), "\"1e-8 mm3/(N m)\"",
                      "k_w of Archard's law, by which a closed cycle of [path] wears the "
                      "surfaces: worn depth over pressure times slip",
                      {.alternative = wear_law}),
         of_wear<&Wear::coefficient>},
        {quantity_key("wear.energy_coefficient", Dimension::wear_rate, above_zero(1),
                      R"("1e-8 mm3/J")", "instead, worn depth over frictional work per area",
                      {.alternative = wear_law}),
         of_wear<&Wear::energy_coefficient>},
        {integer_key("wear.cycles", {1, most_cycles}, "100000",
                     "how often the last closed cycle of [path] is repeated", {.required = true}),
         of_wear<&Wear::cycles>},
        {number_key("wear.tolerance", {1e-6, 0.1}, "1e-3",
                    "error of a jump over cycles in volume, over what it wears",
                    {.default_value = "0.001"}),
         of_wear<&Wear::tolerance>}};
}

}  // namespace tricontact::io

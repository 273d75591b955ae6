#include "contact/heat.h"
#include "io/case/case_keys.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::ContactHeat;
using contact::ThermalBody;

/// The place of a key of one body, where a case states heat at all.
template <double ThermalBody::*member>
Field heat_of_indenter(Case& c) {
    return c.kept.find<ContactHeat>() ? Field(&(c.of<ContactHeat>().indenter.*member)) : Field();
}
template <double ThermalBody::*member>
Field heat_of_substrate(Case& c) {
    return c.kept.find<ContactHeat>() ? Field(&(c.of<ContactHeat>().substrate.*member)) : Field();
}

}  // namespace

std::vector<CaseKey> heat_keys() {
    constexpr Range range = above_zero(1e9);
    constexpr Range temperatures{-273.15, 1e5};
    using enum Dimension;
    return {{quantity_key(
                 "indenter.heat.conductivity", thermal_conductivity, range, "\"50 W/(m K)\"",
                 "lambda of the indenter, for temperatures in steady rolling", {.required = true}),
             heat_of_indenter<&ThermalBody::conductivity>},
            {quantity_key("indenter.heat.specific_heat", specific_heat, range, "\"450 J/(kg K)\"",
                          "its heat capacity c by mass", {.required = true}),
             heat_of_indenter<&ThermalBody::specific_heat>},
            {quantity_key("indenter.heat.density", density, range, R"("7850 kg/m3")",
                          "its density rho", {.required = true}),
             heat_of_indenter<&ThermalBody::density>},
            {quantity_key("indenter.heat.temperature", temperature, temperatures, R"("20 degC")",
                          "of its bulk, away from the contact", {.default_value = R"("0 degC")"}),
             heat_of_indenter<&ThermalBody::temperature>},
            {quantity_key("substrate.heat.conductivity", thermal_conductivity, range,
                          "\"0.2 W/(m K)\"", "the same of the substrate", {.required = true}),
             heat_of_substrate<&ThermalBody::conductivity>},
            {quantity_key("substrate.heat.specific_heat", specific_heat, range, "\"1500 J/(kg K)\"",
                          "its c", {.required = true}),
             heat_of_substrate<&ThermalBody::specific_heat>},
            {quantity_key("substrate.heat.density", density, range, R"("1100 kg/m3")", "its rho",
                          {.required = true}),
             heat_of_substrate<&ThermalBody::density>},
            {quantity_key("substrate.heat.temperature", temperature, temperatures, R"("20 degC")",
                          "of its bulk", {.default_value = R"("0 degC")"}),
             heat_of_substrate<&ThermalBody::temperature>}};
}

}  // namespace tricontact::io

// Keys of what lies between both bodies: [friction], [interface], [contact], [adhesion].

#include "io/case/case_checks.h"
#include "io/case/case_input.h"
#include "io/case/case_keys.h"
#include "io/tables/friction_map_table.h"

namespace tricontact::io {

namespace {

using contact::Adhesion;
using contact::Case;
using contact::Friction;
using Rate = contact::FrictionRate;
using Temperature = contact::FrictionTemperature;
using Weakening = contact::FrictionWeakening;
using Yield = contact::InterfaceYield;

}  // namespace

std::vector<CaseKey> contact_keys() {
    constexpr Range temperatures{-273.15, 1e5};
    return {
        {number_key("friction.coefficient", above_zero(100), "0.57",
                    "Coulomb's coefficient of friction mu; it or the shear strength is needed"),
         at<&Case::friction, &Friction::coefficient>},
        {quantity_key("friction.shear_strength", Dimension::pressure, above_zero(1e15),
                      R"("0.35 MPa")",
                      "tau_0, which the interface carries whatever the pressure, beside mu p"),
         at<&Case::friction, &Friction::shear_strength>},
        {number_key("friction.pressure_exponent", {0, 2, false, true}, "0.8",
                    "n of mu p_r (p/p_r)^n instead of mu p",
                    {.needs = "friction.reference_pressure"}),
         at<&Case::friction, &Friction::pressure_exponent>},
        {quantity_key("friction.reference_pressure", Dimension::pressure, above_zero(1e15),
                      R"("1 MPa")", "its p_r, at which tau is mu p",
                      {.needs = "friction.pressure_exponent"}),
         at<&Case::friction, &Friction::reference_pressure>},
        {quantity_key("friction.strength_limit", Dimension::pressure, above_zero(1e15),
                      R"("2 MPa")", "tau_cap, above which no point carries",
                      {.needs = "friction.coefficient"}),
         at<&Case::friction, &Friction::strength_limit>},
        {text_key("friction.map", R"("friction.csv")",
                  "table of x and a factor of what the other keys say (stripes), or of x, y "
                  "and this factor; where they lie on the substrate"),
         at<&Case::friction, &Friction::map_file>},
        {choice_key("friction.rate.law",
                    {choice("linear", Rate::Law::linear), choice("rational", Rate::Law::rational),
                     choice("exponential", Rate::Law::exponential)},
                    R"("exponential")", "how mu falls with the speed v at which a point slips",
                    {.required = true}),
         at<&Case::friction, &Friction::rate, &Rate::law>},
        {bare_list_of(number_key("friction.rate.drops", {0, 100}, "0.12",
                                 "by how much mu falls in the end, or of two parts each",
                                 {.required = true})),
         at<&Case::friction, &Friction::rate, &Rate::drops>},
        {bare_list_of(quantity_key(
             "friction.rate.speeds", Dimension::velocity, above_zero(1e9), R"("100 mm/s")",
             "v at which it has fallen by half of that, one each", {.required = true})),
         at<&Case::friction, &Friction::rate, &Rate::speeds>},
        {quantity_key("friction.rate.memory_length", Dimension::length, from_zero(1e6), R"("3 um")",
                      "way d_c over which mu follows the speed; 0: at once",
                      {.default_value = R"("0 m")"}),
         at<&Case::friction, &Friction::rate, &Rate::memory_length>},
        {quantity_key("friction.rate.memory_speed", Dimension::velocity, from_zero(1e9),
                      R"("1 mm/s")", "v_0, with which mu follows where nothing slips",
                      {.default_value = R"("0 m/s")"}),
         at<&Case::friction, &Friction::rate, &Rate::memory_speed>},
        {number_key("friction.temperature.change", {-100, 100}, "-0.18",
                    "by how much mu differs in the end from friction.coefficient, by the "
                    "temperature of the surfaces where they touch; it changes linearly between",
                    {.required = true}),
         at<&Case::friction, &Friction::temperature, &Temperature::change>},
        {quantity_key("friction.temperature.from", Dimension::temperature, temperatures,
                      R"("0 degC")", "up to which mu is friction.coefficient", {.required = true}),
         at<&Case::friction, &Friction::temperature, &Temperature::from>},
        {quantity_key("friction.temperature.to", Dimension::temperature, temperatures,
                      R"("400 degC")", "from which on mu has changed", {.required = true}),
         at<&Case::friction, &Friction::temperature, &Temperature::to>},
        {choice_key("friction.weakening.law",
                    {choice("linear", Weakening::Law::linear),
                     choice("exponential", Weakening::Law::exponential)},
                    R"("linear")", "how mu falls with the way s that a point has slipped",
                    {.required = true}),
         at<&Case::friction, &Friction::weakening, &Weakening::law>},
        {number_key("friction.weakening.drop", above_zero(100), "0.2",
                    "by how much mu falls in the end, below friction.coefficient",
                    {.required = true}),
         at<&Case::friction, &Friction::weakening, &Weakening::drop>},
        {quantity_key("friction.weakening.length", Dimension::length, above_zero(1e6), R"("50 um")",
                      "D_c of 1 - s/D_c or exp(-s/D_c); what sticks again begins with s = 0",
                      {.required = true}),
         at<&Case::friction, &Friction::weakening, &Weakening::length>},
        {quantity_key("interface.normal_stiffness", Dimension::pressure_per_length,
                      above_zero(1e20), R"("260 MPa/mm")",
                      "k_n of springs between the surfaces, which p compresses by p/k_n: "
                      "roughness, a third body, a penalty"),
         at<&Case::interface, &contact::Interface::normal_stiffness>},
        {quantity_key("interface.tangential_stiffness", Dimension::pressure_per_length,
                      above_zero(1e20), R"("100 MPa/mm")",
                      "k_t of the same springs, which a traction t shears by t/k_t"),
         at<&Case::interface, &contact::Interface::tangential_stiffness>},
        {quantity_key("interface.yield_stress", Dimension::pressure, above_zero(1e15), R"("2 MPa")",
                      "tau_c0, above which the layer between the surfaces flows, if they do not "
                      "slip before"),
         at<&Case::friction, &Friction::yield, &Yield::stress>},
        {quantity_key("interface.hardening", Dimension::pressure_per_length, {-1e20, 1e20},
                      R"("5 MPa/mm")",
                      "k_tau, by which tau_c rises with the way that a point has flowed; below 0 "
                      "it falls",
                      {.default_value = R"("0 Pa/m")", .needs = "interface.yield_stress"}),
         at<&Case::friction, &Friction::yield, &Yield::hardening>},
        {boolean_key("contact.coupling", "false",
                     "normal and tangential contact influence each other",
                     {.default_value = "true"}),
         at<&Case::contact, &Case::Contact::coupling>}};
}

std::vector<CaseKey> adhesion_keys() {
    return {
        {quantity_key("adhesion.work", Dimension::energy_per_area, above_zero(1e6), R"("50 mJ/m2")",
                      "w, the work per area that separates the surfaces, which attract each "
                      "other",
                      {.required = true}),
         at<&Case::adhesion, &Adhesion::work>},
        {quantity_key("adhesion.approach_work", Dimension::energy_per_area, from_zero(1e6),
                      R"("20 mJ/m2")",
                      "w_a, what is gained as the surfaces come together, at most w: the edge of "
                      "the contact stays where it is as long as less than w parts it and more than "
                      "w_a closes it; w by default"),
         at<&Case::adhesion, &Adhesion::approach_work>},
        {quantity_key("adhesion.range", Dimension::length, from_zero(1e6), R"("0.2 um")",
                      "distance over which they do; 0: none, by Johnson, Kendall and Roberts",
                      {.default_value = R"("0 m")", .alternative = adhesion_range}),
         at<&Case::adhesion, &Adhesion::range>},
        {quantity_key("adhesion.peak_stress", Dimension::pressure, above_zero(1e15),
                      R"("0.25 MPa")",
                      "the largest tension sigma_0, instead: the range is w/sigma_0",
                      {.alternative = adhesion_range, .stands_for = "adhesion.range"}),
         at<&Case::adhesion, &Adhesion::peak_stress>},
        {choice_key("adhesion.law",
                    {choice("dugdale", Adhesion::Law::dugdale),
                     choice("exponential", Adhesion::Law::exponential)},
                    R"("exponential")",
                    "tension over the gap g of a range above 0: \"dugdale\": sigma_0 up to the "
                    "range, \"exponential\": sigma_0 exp(-g/range)",
                    {.default_value = R"("dugdale")", .needs = "adhesion.range"}),
         [](Case& c) {
             return c.adhesion && !c.adhesion->is_short_ranged() ? Field(&c.adhesion->law)
                                                                 : Field();
         }}};
}

void resolve_friction_map(Case& c, const Document& document) {
    if (!c.friction.map_file) return;
    const std::string key = "friction.map";
    check_file_there(document, key, *c.friction.map_file, "name a table");
    told_at(document, key, [&] { c.friction.map = read_friction_map(*c.friction.map_file); });
}

}  // namespace tricontact::io

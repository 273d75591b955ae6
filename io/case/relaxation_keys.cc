#include "io/case/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Relaxation;
using Input = Case::RelaxationInput;

template <class Member>
Field in_relaxation(Case& c, Member Input::*member) {
    return c.relaxation ? Field(&(c.relaxation_input.*member)) : Field();
}

void add_standard_solid(std::vector<CaseKey>& keys) {
    keys.push_back(
        {modulus_key("substrate.relaxation.G2", R"("1 MPa")",
                     "standard solid: shear modulus of the Maxwell element beside the relaxed one",
                     {.alternative = relaxation, .needs = "substrate.relaxation.eta"}),
         [](Case& c) { return in_relaxation(c, &Input::maxwell_modulus); }});
    keys.push_back({quantity_key("substrate.relaxation.eta", Dimension::viscosity, above_zero(1e15),
                                 R"("40 Pa s")", "its viscosity; it relaxes in eta/G2",
                                 {.needs = "substrate.relaxation.G2"}),
                    [](Case& c) { return in_relaxation(c, &Input::viscosity); }});
}

void add_prony_series(std::vector<CaseKey>& keys) {
    keys.push_back({list_of(modulus_key(
                        "substrate.relaxation.moduli", R"(["0.5 MPa", "0.2 MPa"])",
                        "Prony series: shear moduli G_i beside the relaxed one",
                        {.reason = "a negative term would make G(t) grow with time, or negative",
                         .alternative = relaxation,
                         .needs = "substrate.relaxation.times"})),
                    [](Case& c) { return in_relaxation(c, &Input::moduli); }});
    keys.push_back(
        {list_of(quantity_key(
             "substrate.relaxation.times", Dimension::time, above_zero(1e12),
             R"(["0.1 s", "10 s"])", "their relaxation times, one each",
             {.reason = "time does not go backwards", .needs = "substrate.relaxation.moduli"})),
         [](Case& c) { return in_relaxation(c, &Input::times); }});
}

}  // namespace

void add_relaxation_keys(std::vector<CaseKey>& keys) {
    using Bulk = Relaxation::Bulk;
    add_standard_solid(keys);
    add_prony_series(keys);
    keys.push_back({text_key("substrate.relaxation.dma", R"("dma.csv")",
                             "table of frequency, G', G'' to which a Prony series is fitted",
                             {.alternative = relaxation}),
                    [](Case& c) { return in_relaxation(c, &Input::dma); }});
    keys.push_back(
        {choice_key("substrate.relaxation.bulk",
                    {choice("proportional", Bulk::proportional), choice("elastic", Bulk::elastic)},
                    R"("proportional")",
                    "the bulk modulus relaxes like the shear modulus, or not at all",
                    {.default_value = R"("proportional")"}),
         [](Case& c) { return in(c.relaxation, &Relaxation::bulk); }});
}

}  // namespace tricontact::io

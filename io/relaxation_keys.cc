#include "io/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Relaxation;
using Input = Case::RelaxationInput;
using Kind = Key::Kind;

template <class Member>
Field in_relaxation(Case& c, Member Input::*member) {
    return c.relaxation ? Field(&(c.relaxation_input.*member)) : Field();
}

void add_standard_solid(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "substrate.relaxation.G2",
                     .kind = Kind::quantity,
                     .dimension = Dimension::pressure,
                     .range = above_zero(1e15),
                     .alternative = relaxation,
                     .needs = "substrate.relaxation.eta",
                     .example = R"("1 MPa")",
                     .text = "standard solid: shear modulus of the Maxwell element beside the "
                             "relaxed one"},
                    [](Case& c) { return in_relaxation(c, &Input::maxwell_modulus); }});
    keys.push_back({{.path = "substrate.relaxation.eta",
                     .kind = Kind::quantity,
                     .dimension = Dimension::viscosity,
                     .range = above_zero(1e15),
                     .needs = "substrate.relaxation.G2",
                     .example = R"("40 Pa s")",
                     .text = "its viscosity; it relaxes in eta/G2"},
                    [](Case& c) { return in_relaxation(c, &Input::viscosity); }});
}

void add_prony_series(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "substrate.relaxation.moduli",
                     .kind = Kind::quantity_list,
                     .dimension = Dimension::pressure,
                     .range = above_zero(1e15),
                     .reason = "a negative term would make G(t) grow with time, or negative",
                     .alternative = relaxation,
                     .needs = "substrate.relaxation.times",
                     .example = R"(["0.5 MPa", "0.2 MPa"])",
                     .text = "Prony series: shear moduli G_i beside the relaxed one"},
                    [](Case& c) { return in_relaxation(c, &Input::moduli); }});
    keys.push_back({{.path = "substrate.relaxation.times",
                     .kind = Kind::quantity_list,
                     .dimension = Dimension::time,
                     .range = above_zero(1e12),
                     .reason = "time does not go backwards",
                     .needs = "substrate.relaxation.moduli",
                     .example = R"(["0.1 s", "10 s"])",
                     .text = "their relaxation times, one each"},
                    [](Case& c) { return in_relaxation(c, &Input::times); }});
}

}  // namespace

void add_relaxation_keys(std::vector<CaseKey>& keys) {
    using Bulk = Relaxation::Bulk;
    add_standard_solid(keys);
    add_prony_series(keys);
    keys.push_back({{.path = "substrate.relaxation.dma",
                     .kind = Kind::text,
                     .alternative = relaxation,
                     .example = R"("dma.csv")",
                     .text = "table of frequency, G', G'' to which a Prony series is fitted"},
                    [](Case& c) { return in_relaxation(c, &Input::dma); }});
    keys.push_back(
        {{.path = "substrate.relaxation.bulk",
          .kind = Kind::choice,
          .choices = {choice("proportional", Bulk::proportional), choice("elastic", Bulk::elastic)},
          .default_value = R"("proportional")",
          .example = R"("proportional")",
          .text = "the bulk modulus relaxes like the shear modulus, or not at all"},
         [](Case& c) { return in(c.relaxation, &Relaxation::bulk); }});
}

}  // namespace tricontact::io

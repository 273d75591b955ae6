#include "contact/bodies/upper_plate.h"
#include "io/case/case_input.h"
#include "io/case/case_keys.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Material;
using contact::Relaxation;
using contact::UpperPlate;
using Layer = Case::Layer;
using Lower = LayersInput::Lower;
using Input = RelaxationInput;
using Bulk = Relaxation::Bulk;
using Body = Relaxation::Body;

/// How a relaxing case says its Prony series.
template <auto... members>
Field of_series(Case& c) {
    return c.relaxation ? in(c.of<Input>(), members...) : Field();
}

/// Of a substrate that deforms.
template <double Material::*member>
Field of_elastic_substrate(Case& c) {
    return c.has_rigid_substrate ? Field() : Field(&(c.substrate.*member));
}

Field rigid_plate(Case& c) {
    const auto* const plate = c.kept.find<UpperPlate>();
    return plate && plate->is_rigid ? Field(&c.of<UpperPlate>().is_rigid) : Field();
}
/// Of a plate that deforms.
template <auto... members>
Field of_plate(Case& c) {
    const auto* const plate = c.kept.find<UpperPlate>();
    return plate && !plate->is_rigid ? in(c.of<UpperPlate>(), members...) : Field();
}

}  // namespace

std::vector<CaseKey> substrate_keys() {
    return {
        {boolean_key(
             "substrate.rigid", "true",
             "the substrate is rigid, a plane or a hole, and an elastic indenter is pressed on it",
             {.needs = "indenter.young"}),
         [](Case& c) { return c.has_rigid_substrate ? Field(&c.has_rigid_substrate) : Field(); }},
        {choice_key("substrate.shape",
                    {choice("layer", Case::SubstrateShape::layer),
                     choice("hole", Case::SubstrateShape::hole)},
                    R"("hole")",
                    "a flat layer or half-space, which it is without this key, or a plate about a "
                    "round hole along y, in which a cylinder is pressed in plane strain"),
         [](Case& c) { return c.has_hole() ? Field(&c.substrate_shape) : Field(); }},
        {length_key("substrate.hole_radius", R"("10.05 mm")",
                    "radius of the hole; less that of the cylinder it is the clearance",
                    {.required = true, .needs = "substrate.shape"}),
         [](Case& c) { return c.has_hole() ? Field(&c.hole.radius) : Field(); }},
        {length_key("substrate.outer_radius", R"("100 mm")",
                    "radius of the plate about the hole, whose edge is held",
                    {.required = true, .needs = "substrate.shape"}),
         [](Case& c) {
             return c.has_hole() && !c.has_rigid_substrate ? Field(&c.hole.outer_radius) : Field();
         }},
        {modulus_key("substrate.young", R"("5.2 MPa")", "Young's modulus", {.required = true}),
         of_elastic_substrate<&Material::young>},
        {poisson_key("substrate.poisson", "0.5", "Poisson's ratio; 0.5 is incompressible",
                     {.required = true}),
         of_elastic_substrate<&Material::poisson>},
        {quantity_key("substrate.yield_stress", Dimension::pressure, above_zero(1e15),
                      R"("800 MPa")",
                      "yield stress Y in tension, for findings about its strength alone: models "
                      "are elastic",
                      {.needs = "substrate.young"}),
         at<&Case::yield_stress, &Case::YieldStresses::substrate>},
        {choice_key(
             "substrate.material",
             {choice("linear", Case::Law::linear), choice("neo-hookean", Case::Law::neo_hookean),
              choice("mooney-rivlin", Case::Law::mooney_rivlin)},
             R"("neo-hookean")",
             "law of elasticity in fem: linear, or a rubber at finite strains under a "
             "paraboloid or sphere, whose contact is that of the deformed surface; all "
             "other models are linear",
             {.default_value = R"("linear")"}),
         [](Case& c) { return c.has_rigid_substrate ? Field() : Field(&c.law); }},
        {number_key("substrate.c01_ratio", {0, 1, true, true}, "0.2",
                    "share of the second constant, c01/(c10 + c01), in the shear modulus of a "
                    "Mooney-Rivlin material, 2 (c10 + c01)",
                    {.needs = "substrate.material"}),
         at<&Case::c01_ratio>},
        {length_key("substrate.thickness", R"("8 mm")",
                    "thickness b of the layer; half-space models do not see it"),
         at<&Case::layer, &Layer::thickness>},
        {number_key("substrate.thickness_ratio", above_zero(1e6), "0.9",
                    "b/(2a), thickness over the diameter of the contact on the half-space (of a "
                    "cylinder the width) under the mean normal load",
                    {.stands_for = "substrate.thickness"}),
         kept<&LayersInput::thickness_ratio>},
        {choice_key(
             "substrate.base",
             {choice("bonded", Case::Base::bonded),
              choice("frictionless", Case::Base::frictionless),
              choice("half-space", Case::Base::half_space)},
             R"("bonded")",
             "what the lowest layer rests on: rigid ground, to which it is bonded or on which it "
             "glides, or the elastic half-space of `[ground]`, to which it is bonded",
             {.default_value = R"("bonded")", .needs = "substrate.thickness"}),
         [](Case& c) {
             const bool layer = c.layer.thickness || c.of<LayersInput>().thickness_ratio;
             return layer ? Field(&c.layer.base) : Field();
         }},
        {length_key("substrate.width", R"("60 mm")", "extent along x; without it unbounded",
                    {.needs = "substrate.thickness"}),
         at<&Case::layer, &Layer::width>},
        {length_key("substrate.depth", R"("60 mm")", "extent along y; without it unbounded",
                    {.needs = "substrate.thickness"}),
         at<&Case::layer, &Layer::depth>},
        {bare_list_of(length_key("lower_layer.thickness", R"("2 mm")",
                                 "thickness of a second elastic layer below the "
                                 "substrate's, or of several from the top down",
                                 {.required = true, .needs = "substrate.thickness"})),
         kept<&LayersInput::lower, &Lower::thickness>},
        {bare_list_of(modulus_key("lower_layer.young", R"("70 GPa")",
                                  "Young's modulus, one for each of them", {.required = true})),
         kept<&LayersInput::lower, &Lower::young>},
        {bare_list_of(poisson_key("lower_layer.poisson", "0.33",
                                  "Poisson's ratio, one for each of them; 0.5 is incompressible",
                                  {.required = true})),
         kept<&LayersInput::lower, &Lower::poisson>},
        {modulus_key("ground.young", R"("70 GPa")",
                     "Young's modulus of the half-space below all layers",
                     {.required = true, .needs = "substrate.base"}),
         at<&Case::layer, &Layer::ground, &Material::young>},
        {poisson_key("ground.poisson", "0.33", "Poisson's ratio; 0.5 is incompressible",
                     {.required = true}),
         at<&Case::layer, &Layer::ground, &Material::poisson>}};
}

std::vector<CaseKey> upper_plate_keys() {
    return {
        {boolean_key("upper_plate.rigid", "true",
                     "the plate above a body between two plates is rigid, unlike the substrate"),
         rigid_plate},
        {modulus_key("upper_plate.young", R"("5.2 MPa")",
                     "Young's modulus of that plate, a layer bonded to rigid ground; without "
                     "[upper_plate] both plates are like the substrate",
                     {.required = true}),
         of_plate<&UpperPlate::material, &Material::young>},
        {poisson_key("upper_plate.poisson", "0.3", "its Poisson's ratio", {.required = true}),
         of_plate<&UpperPlate::material, &Material::poisson>},
        {length_key("upper_plate.thickness", R"("8 mm")", "its thickness", {.required = true}),
         of_plate<&UpperPlate::thickness>}};
}

std::vector<CaseKey> relaxation_keys() {
    return {
        {modulus_key("substrate.relaxation.G2", R"("1 MPa")",
                     "standard solid: shear modulus of the Maxwell element beside the relaxed one",
                     {.alternative = relaxation, .needs = "substrate.relaxation.eta"}),
         of_series<&Input::maxwell_modulus>},
        {quantity_key("substrate.relaxation.eta", Dimension::viscosity, above_zero(1e15),
                      R"("40 Pa s")", "its viscosity; it relaxes in eta/G2",
                      {.needs = "substrate.relaxation.G2"}),
         of_series<&Input::viscosity>},
        {list_of(
             modulus_key("substrate.relaxation.moduli", R"(["0.5 MPa", "0.2 MPa"])",
                         "Prony series: shear moduli G_i beside the relaxed one",
                         {.reason = "a negative term would make G(t) grow with time, or negative",
                          .alternative = relaxation,
                          .needs = "substrate.relaxation.times"})),
         of_series<&Input::moduli>},
        {list_of(
             number_key("substrate.relaxation.relative_moduli", {0, 1, false, false}, "[0.3, 0.2]",
                        "the same as g_i = G_i/G_0 of the unrelaxed modulus; their sum is below 1",
                        {.alternative = relaxation, .needs = "substrate.relaxation.times"})),
         of_series<&Input::relative_moduli>},
        {list_of(quantity_key("substrate.relaxation.times", Dimension::time, above_zero(1e12),
                              R"(["0.1 s", "10 s"])", "their relaxation times, one each",
                              {.reason = "time does not go backwards"})),
         of_series<&Input::times>},
        {text_key("substrate.relaxation.dma", R"("dma.csv")",
                  "table of frequency, G', G'' to which a Prony series is fitted",
                  {.alternative = relaxation}),
         of_series<&Input::dma>},
        {text_key("substrate.relaxation.test", R"("relaxation.csv")",
                  "table of a relaxation test, time and E or G, to which a Prony series is fitted",
                  {.alternative = relaxation}),
         of_series<&Input::test>},
        {choice_key("substrate.relaxation.modulus",
                    {choice("relaxed", Input::Modulus::relaxed),
                     choice("unrelaxed", Input::Modulus::unrelaxed)},
                    R"("unrelaxed")",
                    "what substrate.young is: the modulus of rest, or that at once",
                    {.default_value = R"("relaxed")"}),
         of_series<&Input::modulus>},
        {choice_key("substrate.relaxation.bulk",
                    {choice("proportional", Bulk::proportional), choice("elastic", Bulk::elastic)},
                    R"("proportional")",
                    "the bulk modulus relaxes like the shear modulus, or not at all",
                    {.default_value = R"("proportional")"}),
         at<&Case::relaxation, &Relaxation::bulk>},
        {choice_key("substrate.relaxation.body",
                    {choice("substrate", Body::substrate), choice("indenter", Body::indenter),
                     choice("both", Body::both)},
                    R"("substrate")",
                    "what relaxes: the substrate, the indenter of this young and poisson, or both "
                    "by the same terms; an indenter that relaxes does not roll",
                    {.default_value = R"("substrate")"}),
         at<&Case::relaxation, &Relaxation::body>}};
}

}  // namespace tricontact::io

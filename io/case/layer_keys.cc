#include "io/case/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Material;

void add_extent(std::vector<CaseKey>& keys) {
    keys.push_back({length_key("substrate.thickness", R"("8 mm")",
                               "thickness b of the layer; half-space models do not see it"),
                    [](Case& c) -> Field { return &c.layer.thickness; }});
    keys.push_back(
        {choice_key(
             "substrate.base",
             {choice("bonded", Case::Base::bonded),
              choice("frictionless", Case::Base::frictionless),
              choice("half-space", Case::Base::half_space)},
             R"("bonded")",
             "what the lowest layer rests on: rigid ground, to which it is bonded or on which it "
             "glides, or the elastic half-space of `[ground]`, to which it is bonded",
             {.default_value = R"("bonded")", .needs = "substrate.thickness"}),
         [](Case& c) { return c.layer.thickness ? Field(&c.layer.base) : Field(); }});
    keys.push_back({length_key("substrate.width", R"("60 mm")",
                               "extent along x; without it wide enough not to matter",
                               {.needs = "substrate.thickness"}),
                    [](Case& c) -> Field { return &c.layer.width; }});
    keys.push_back({length_key("substrate.depth", R"("60 mm")",
                               "extent along y; without it wide enough not to matter",
                               {.needs = "substrate.thickness"}),
                    [](Case& c) -> Field { return &c.layer.depth; }});
}

void add_lower_layers(std::vector<CaseKey>& keys) {
    using Input = Case::LowerLayersInput;
    keys.push_back({bare_list_of(length_key("lower_layer.thickness", R"("2 mm")",
                                            "thickness of a second elastic layer below the "
                                            "substrate's, or of several from the top down",
                                            {.required = true, .needs = "substrate.thickness"})),
                    [](Case& c) { return in(c.lower_layers_input, &Input::thickness); }});
    keys.push_back(
        {bare_list_of(modulus_key("lower_layer.young", R"("70 GPa")",
                                  "Young's modulus, one for each of them", {.required = true})),
         [](Case& c) { return in(c.lower_layers_input, &Input::young); }});
    keys.push_back(
        {bare_list_of(poisson_key("lower_layer.poisson", "0.33",
                                  "Poisson's ratio, one for each of them; 0.5 is incompressible",
                                  {.required = true})),
         [](Case& c) { return in(c.lower_layers_input, &Input::poisson); }});
}

void add_ground(std::vector<CaseKey>& keys) {
    keys.push_back({modulus_key("ground.young", R"("70 GPa")",
                                "Young's modulus of the half-space below all layers",
                                {.required = true, .needs = "substrate.base"}),
                    [](Case& c) { return in(c.layer.ground, &Material::young); }});
    keys.push_back({poisson_key("ground.poisson", "0.33", "Poisson's ratio; 0.5 is incompressible",
                                {.required = true}),
                    [](Case& c) { return in(c.layer.ground, &Material::poisson); }});
}

}  // namespace

void add_layer_keys(std::vector<CaseKey>& keys) {
    add_extent(keys);
    add_lower_layers(keys);
    add_ground(keys);
}

void add_contact_keys(std::vector<CaseKey>& keys) {
    using Kinematics = Case::Kinematics;
    keys.push_back({boolean_key("contact.coupling", "false",
                                "normal and tangential contact influence each other",
                                {.default_value = "true"}),
                    [](Case& c) -> Field { return &c.contact.coupling; }});
    keys.push_back({choice_key("contact.kinematics",
                               {choice("linear", Kinematics::linear),
                                choice("deformed", Kinematics::deformed)},
                               R"("linear")",
                               "where models that can take gap and normal: at the undeformed "
                               "surface point, or at the displaced one",
                               {.default_value = R"("linear")"}),
                    [](Case& c) -> Field { return &c.contact.kinematics; }});
}

}  // namespace tricontact::io

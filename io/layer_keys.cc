#include "io/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Material;
using Kind = Key::Kind;

void add_extent(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "substrate.thickness",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .example = R"("8 mm")",
                     .text = "thickness b of the layer; half-space models do not see it"},
                    [](Case& c) -> Field { return &c.layer.thickness; }});
    keys.push_back(
        {{.path = "substrate.base",
          .kind = Kind::choice,
          .choices = {choice("bonded", Case::Base::bonded),
                      choice("frictionless", Case::Base::frictionless),
                      choice("half-space", Case::Base::half_space)},
          .default_value = R"("bonded")",
          .needs = "substrate.thickness",
          .example = R"("bonded")",
          .text =
              "what the lowest layer rests on: rigid ground, to which it is bonded or on which it "
              "glides, or the elastic half-space of `[ground]`, to which it is bonded"},
         [](Case& c) { return c.layer.thickness ? Field(&c.layer.base) : Field(); }});
    keys.push_back({{.path = "substrate.width",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .needs = "substrate.thickness",
                     .example = R"("60 mm")",
                     .text = "extent along x; without it wide enough not to matter"},
                    [](Case& c) -> Field { return &c.layer.width; }});
    keys.push_back({{.path = "substrate.depth",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .needs = "substrate.thickness",
                     .example = R"("60 mm")",
                     .text = "extent along y; without it wide enough not to matter"},
                    [](Case& c) -> Field { return &c.layer.depth; }});
}

void add_lower_layers(std::vector<CaseKey>& keys) {
    using Input = Case::LowerLayersInput;
    keys.push_back({{.path = "lower_layer.thickness",
                     .kind = Kind::quantity_list,
                     .dimension = Dimension::length,
                     .bare = true,
                     .range = above_zero(1e6),
                     .required = true,
                     .needs = "substrate.thickness",
                     .example = R"("2 mm")",
                     .text = "thickness of a second elastic layer below the substrate's, or of "
                             "several from the top down"},
                    [](Case& c) { return in(c.lower_layers_input, &Input::thickness); }});
    keys.push_back({{.path = "lower_layer.young",
                     .kind = Kind::quantity_list,
                     .dimension = Dimension::pressure,
                     .bare = true,
                     .range = above_zero(1e15),
                     .required = true,
                     .example = R"("70 GPa")",
                     .text = "Young's modulus, one for each of them"},
                    [](Case& c) { return in(c.lower_layers_input, &Input::young); }});
    keys.push_back({{.path = "lower_layer.poisson",
                     .kind = Kind::number_list,
                     .bare = true,
                     .range = {-1, 0.5, false, true},
                     .required = true,
                     .example = "0.33",
                     .text = "Poisson's ratio, one for each of them; 0.5 is incompressible"},
                    [](Case& c) { return in(c.lower_layers_input, &Input::poisson); }});
}

void add_ground(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "ground.young",
                     .kind = Kind::quantity,
                     .dimension = Dimension::pressure,
                     .range = above_zero(1e15),
                     .required = true,
                     .needs = "substrate.base",
                     .example = R"("70 GPa")",
                     .text = "Young's modulus of the half-space below all layers"},
                    [](Case& c) { return in(c.layer.ground, &Material::young); }});
    keys.push_back({{.path = "ground.poisson",
                     .kind = Kind::number,
                     .range = {-1, 0.5, false, true},
                     .required = true,
                     .example = "0.33",
                     .text = "Poisson's ratio; 0.5 is incompressible"},
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
    keys.push_back({{.path = "contact.coupling",
                     .kind = Kind::boolean,
                     .default_value = "true",
                     .example = "false",
                     .text = "normal and tangential contact influence each other"},
                    [](Case& c) -> Field { return &c.contact.coupling; }});
    keys.push_back({{.path = "contact.kinematics",
                     .kind = Kind::choice,
                     .choices = {choice("linear", Kinematics::linear),
                                 choice("deformed", Kinematics::deformed)},
                     .default_value = R"("linear")",
                     .example = R"("linear")",
                     .text = "where models that can take gap and normal: at the undeformed surface "
                             "point, or at the displaced one"},
                    [](Case& c) -> Field { return &c.contact.kinematics; }});
}

}  // namespace tricontact::io

#include "io/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using Kind = Key::Kind;

void add_mesh(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "fem.accuracy",
                     .kind = Kind::number,
                     .range = {1e-5, 0.2, false, true},
                     .default_value = "0.01",
                     .alternative = element_size,
                     .example = "0.01",
                     .text = "relative accuracy of the normal contact; the size is chosen for it"},
                    [](Case& c) -> Field { return &c.fem.accuracy; }});
    keys.push_back({{.path = "fem.size",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .alternative = element_size,
                     .example = R"("0.5 mm")",
                     .text = "edge of an element in the contact patch"},
                    [](Case& c) -> Field { return &c.fem.size; }});
    keys.push_back({{.path = "fem.mesh",
                     .kind = Kind::text,
                     .alternative = element_size,
                     .example = R"("layer.msh")",
                     .text = "gmsh file to be used instead of a mesh of the program's own"},
                    [](Case& c) -> Field { return &c.fem.mesh; }});
    keys.push_back({{.path = "fem.mesh_unit",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .default_value = R"("1 m")",
                     .needs = "fem.mesh",
                     .example = R"("1 mm")",
                     .text = "length of 1 in that file"},
                    [](Case& c) { return c.fem.mesh ? Field(&c.fem.mesh_unit) : Field(); }});
    keys.push_back({{.path = "fem.growth",
                     .kind = Kind::number,
                     .range = {1.05, 3},
                     .default_value = "1.8",
                     .example = "1.8",
                     .text = "ratio of neighbouring elements outwards from the contact patch"},
                    [](Case& c) -> Field { return &c.fem.growth; }});
}

}  // namespace

void add_fem_keys(std::vector<CaseKey>& keys) {
    add_mesh(keys);
    keys.push_back(
        {{.path = "fem.sides",
          .kind = Kind::choice,
          .choices = {choice("free", Case::Sides::free), choice("fixed", Case::Sides::fixed)},
          .default_value = R"("free")",
          .example = R"("free")",
          .text = "how the sides of the block are held"},
         [](Case& c) -> Field { return &c.fem.sides; }});
    keys.push_back({{.path = "fem.tolerance",
                     .kind = Kind::number,
                     .range = {1e-14, 1e-2, false, true},
                     .default_value = "1e-06",
                     .example = "1e-6",
                     .text = "relative tolerance of the contact solvers"},
                    [](Case& c) -> Field { return &c.fem.tolerance; }});
    keys.push_back(
        {{.path = "fem.cache",
          .kind = Kind::text,
          .default_value = "\"\"",
          .example = R"("condensed")",
          .text = "folder that keeps condensed layers for later runs; `\"\"`: that of the "
                  "user, `\"none\"`: nothing is kept"},
         [](Case& c) -> Field { return &c.fem.cache; }});
}

}  // namespace tricontact::io

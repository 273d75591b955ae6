#include "io/case/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;

void add_mesh(std::vector<CaseKey>& keys) {
    keys.push_back({number_key("fem.accuracy", {1e-5, 0.2, false, true}, "0.01",
                               "relative accuracy of the normal contact; the size is chosen for it",
                               {.default_value = "0.01", .alternative = element_size}),
                    [](Case& c) -> Field { return &c.fem.accuracy; }});
    keys.push_back({length_key("fem.size", R"("0.5 mm")", "edge of an element in the contact patch",
                               {.alternative = element_size}),
                    [](Case& c) -> Field { return &c.fem.size; }});
    keys.push_back({text_key("fem.mesh", R"("layer.msh")",
                             "gmsh file to be used instead of a mesh of the program's own",
                             {.alternative = element_size}),
                    [](Case& c) -> Field { return &c.fem.mesh; }});
    keys.push_back({length_key("fem.mesh_unit", R"("1 mm")", "length of 1 in that file",
                               {.default_value = R"("1 m")", .needs = "fem.mesh"}),
                    [](Case& c) { return c.fem.mesh ? Field(&c.fem.mesh_unit) : Field(); }});
    keys.push_back({number_key("fem.growth", {1.05, 3}, "1.8",
                               "ratio of neighbouring elements outwards from the contact patch",
                               {.default_value = "1.8"}),
                    [](Case& c) -> Field { return &c.fem.growth; }});
}

}  // namespace

void add_fem_keys(std::vector<CaseKey>& keys) {
    add_mesh(keys);
    keys.push_back(
        {choice_key(
             "fem.sides", {choice("free", Case::Sides::free), choice("fixed", Case::Sides::fixed)},
             R"("free")", "how the sides of the block are held", {.default_value = R"("free")"}),
         [](Case& c) -> Field { return &c.fem.sides; }});
    keys.push_back(
        {number_key("fem.tolerance", {1e-14, 1e-2, false, true}, "1e-6",
                    "relative tolerance of the contact solvers", {.default_value = "1e-06"}),
         [](Case& c) -> Field { return &c.fem.tolerance; }});
    keys.push_back({text_key("fem.cache", R"("condensed")",
                             "folder that keeps condensed layers for later runs; `\"\"`: that of "
                             "the user, `\"none\"`: nothing is kept",
                             {.default_value = "\"\""}),
                    [](Case& c) -> Field { return &c.fem.cache; }});
}

}  // namespace tricontact::io

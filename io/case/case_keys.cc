#include "io/case/case_keys.h"

#include <algorithm>

namespace tricontact::io {

namespace {

using contact::Case;

void add_top(std::vector<CaseKey>& keys) {
    keys.push_back(
        {text_key("title", R"("Sphere on rubber")", "what the case is", {.default_value = "\"\""}),
         [](Case& c) -> Field { return &c.title; }});
    keys.push_back({list_of(choice_key(
                        "models", {{"mdr"}, {"mdr-layer"}, {"bem"}, {"bem-layer"}, {"fem"}},
                        R"(["mdr", "bem"])", "models that compute the case", {.required = true})),
                    [](Case& c) -> Field { return &c.models; }});
}

void add_substrate(std::vector<CaseKey>& keys) {
    keys.push_back(
        {modulus_key("substrate.young", R"("5.2 MPa")", "Young's modulus", {.required = true}),
         [](Case& c) -> Field { return &c.substrate.young; }});
    keys.push_back({poisson_key("substrate.poisson", "0.5",
                                "Poisson's ratio; 0.5 is incompressible", {.required = true}),
                    [](Case& c) -> Field { return &c.substrate.poisson; }});
}

void add_friction(std::vector<CaseKey>& keys) {
    keys.push_back({number_key("friction.coefficient", above_zero(100), "0.57",
                               "Coulomb's coefficient of friction", {.required = true}),
                    [](Case& c) -> Field { return &c.friction_coefficient; }});
}

void add_bem(std::vector<CaseKey>& keys) {
    keys.push_back(
        {number_key("bem.cells_per_radius", {2, 4096}, "22.5", "cells in Hertz' contact radius",
                    {.default_value = "22.5", .alternative = cell_size}),
         [](Case& c) -> Field { return &c.bem.cells_per_radius; }});
    keys.push_back({length_key("bem.spacing", R"("0.2 mm")", "edge length of a cell",
                               {.alternative = cell_size}),
                    [](Case& c) -> Field { return &c.bem.spacing; }});
    keys.push_back({number_key("bem.tolerance", {1e-14, 1e-2, false, true}, "1e-7",
                               "relative tolerance of the solvers", {.default_value = "1e-07"}),
                    [](Case& c) -> Field { return &c.bem.tolerance; }});
    keys.push_back({text_key("bem.influence", R"("influence.txt")",
                             "file of influence coefficients to be used instead of those of the "
                             "program's own bodies"),
                    [](Case& c) -> Field { return &c.bem.influence; }});
    keys.push_back(
        {length_key("bem.period", R"("80 mm")",
                    "period of indenters and tractions in x and y, for bem-layer, and for "
                    "bem under nominally flat bodies; without it there is one indenter"),
         [](Case& c) -> Field { return &c.bem.period; }});
}

void add_mdr(std::vector<CaseKey>& keys) {
    keys.push_back({integer_key("mdr.springs", {10, 1e7}, "10000",
                                "springs of the whole bed, contact and rolling path",
                                {.default_value = "10000"}),
                    [](Case& c) -> Field { return &c.mdr.springs; }});
}

void add_fem(std::vector<CaseKey>& keys) {
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

void add_output(std::vector<CaseKey>& keys) {
    using Vtk = Case::VtkOutput;
    using Volume = Case::VolumeOutput;
    keys.push_back(
        {choice_key("output.vtk",
                    {choice("none", Vtk::none), choice("quarters", Vtk::quarters),
                     choice("all", Vtk::all)},
                    R"("quarters")",
                    "surfaces written for ParaView: none, each quarter period, all steps",
                    {.default_value = R"("quarters")"}),
         [](Case& c) -> Field { return &c.output.vtk; }});
    keys.push_back(
        {choice_key("output.volume",
                    {choice("none", Volume::none), choice("last", Volume::last),
                     choice("quarters", Volume::quarters)},
                    R"("last")",
                    "interior written for ParaView where a model knows it: none, the last "
                    "state, each quarter period",
                    {.default_value = R"("none")"}),
         [](Case& c) -> Field { return &c.output.volume; }});
    keys.push_back(
        {length_key("output.volume_depth", R"("10 mm")",
                    "how deep the volumes of bem and bem-layer reach, at most through the "
                    "layers; without it 3 contact radii (Hertz)"),
         [](Case& c) -> Field { return &c.output.volume_depth; }});
}

const std::vector<CaseKey>& declared_keys() {
    static const std::vector<CaseKey> keys = [] {
        std::vector<CaseKey> all;
        add_top(all);
        add_indenter_keys(all);
        add_roughness_keys(all);
        add_substrate(all);
        add_layer_keys(all);
        add_relaxation_keys(all);
        add_friction(all);
        add_contact_keys(all);
        add_loading_keys(all);
        add_tractive_keys(all);
        add_bem(all);
        add_mdr(all);
        add_fem(all);
        add_output(all);
        return all;
    }();
    return keys;
}

}  // namespace

std::span<const CaseKey> case_keys() {
    return declared_keys();
}

const KeyList& case_key_list() {
    static const KeyList list(declared_keys(), "docs/case-file.md");
    return list;
}

const CaseKey* find_key(std::string_view path) {
    return static_cast<const CaseKey*>(case_key_list().find(path));
}

bool is_section(std::string_view name) {
    return case_key_list().has_section(name);
}

}  // namespace tricontact::io

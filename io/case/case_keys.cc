#include "io/case/case_keys.h"

#include <algorithm>

#include "io/case/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using Kind = Key::Kind;

void add_top(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "title",
                     .kind = Kind::text,
                     .default_value = "\"\"",
                     .example = R"("Sphere on rubber")",
                     .text = "what the case is"},
                    [](Case& c) -> Field { return &c.title; }});
    keys.push_back({{.path = "models",
                     .kind = Kind::choice_list,
                     .choices = {{"mdr"}, {"mdr-layer"}, {"bem"}, {"bem-layer"}, {"fem"}},
                     .required = true,
                     .example = R"(["mdr", "bem"])",
                     .text = "models that compute the case"},
                    [](Case& c) -> Field { return &c.models; }});
}

void add_substrate(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "substrate.young",
                     .kind = Kind::quantity,
                     .dimension = Dimension::pressure,
                     .range = above_zero(1e15),
                     .required = true,
                     .example = R"("5.2 MPa")",
                     .text = "Young's modulus"},
                    [](Case& c) -> Field { return &c.substrate.young; }});
    keys.push_back({{.path = "substrate.poisson",
                     .kind = Kind::number,
                     .range = {-1, 0.5, false, true},
                     .required = true,
                     .example = "0.5",
                     .text = "Poisson's ratio; 0.5 is incompressible"},
                    [](Case& c) -> Field { return &c.substrate.poisson; }});
}

void add_friction(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "friction.coefficient",
                     .kind = Kind::number,
                     .range = above_zero(100),
                     .required = true,
                     .example = "0.57",
                     .text = "Coulomb's coefficient of friction"},
                    [](Case& c) -> Field { return &c.friction_coefficient; }});
}

void add_bem(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "bem.cells_per_radius",
                     .kind = Kind::number,
                     .range = {2, 4096},
                     .default_value = "22.5",
                     .alternative = cell_size,
                     .example = "22.5",
                     .text = "cells in Hertz' contact radius"},
                    [](Case& c) -> Field { return &c.bem.cells_per_radius; }});
    keys.push_back({{.path = "bem.spacing",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .alternative = cell_size,
                     .example = R"("0.2 mm")",
                     .text = "edge length of a cell"},
                    [](Case& c) -> Field { return &c.bem.spacing; }});
    keys.push_back({{.path = "bem.tolerance",
                     .kind = Kind::number,
                     .range = {1e-14, 1e-2, false, true},
                     .default_value = "1e-07",
                     .example = "1e-7",
                     .text = "relative tolerance of the solvers"},
                    [](Case& c) -> Field { return &c.bem.tolerance; }});
    keys.push_back({{.path = "bem.influence",
                     .kind = Kind::text,
                     .example = R"("influence.txt")",
                     .text = "file of influence coefficients to be used instead of those of the "
                             "program's own bodies"},
                    [](Case& c) -> Field { return &c.bem.influence; }});
    keys.push_back({{.path = "bem.period",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .example = R"("80 mm")",
                     .text = "period of indenters and tractions in x and y, for bem-layer, and for "
                             "bem under nominally flat bodies; without it there is one indenter"},
                    [](Case& c) -> Field { return &c.bem.period; }});
}

void add_mdr(std::vector<CaseKey>& keys) {
    keys.push_back({{.path = "mdr.springs",
                     .kind = Kind::integer,
                     .range = {10, 1e7},
                     .default_value = "10000",
                     .example = "10000",
                     .text = "springs of the whole bed, contact and rolling path"},
                    [](Case& c) -> Field { return &c.mdr.springs; }});
}

void add_output(std::vector<CaseKey>& keys) {
    using Vtk = Case::VtkOutput;
    using Volume = Case::VolumeOutput;
    keys.push_back({{.path = "output.vtk",
                     .kind = Kind::choice,
                     .choices = {choice("none", Vtk::none), choice("quarters", Vtk::quarters),
                                 choice("all", Vtk::all)},
                     .default_value = R"("quarters")",
                     .example = R"("quarters")",
                     .text = "surfaces written for ParaView: none, each quarter period, all steps"},
                    [](Case& c) -> Field { return &c.output.vtk; }});
    keys.push_back({{.path = "output.volume",
                     .kind = Kind::choice,
                     .choices = {choice("none", Volume::none), choice("last", Volume::last),
                                 choice("quarters", Volume::quarters)},
                     .default_value = R"("none")",
                     .example = R"("last")",
                     .text = "interior written for ParaView where a model knows it: none, the last "
                             "state, each quarter period"},
                    [](Case& c) -> Field { return &c.output.volume; }});
    keys.push_back({{.path = "output.volume_depth",
                     .kind = Kind::quantity,
                     .dimension = Dimension::length,
                     .range = above_zero(1e6),
                     .example = R"("10 mm")",
                     .text = "how deep the volumes of bem and bem-layer reach, at most through the "
                             "layers; without it 3 contact radii (Hertz)"},
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
        add_fem_keys(all);
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

#include "io/case/case_keys.h"

#include <algorithm>
#include <iterator>

#include "bem/settings.h"
#include "contact/attraction/adhesive_edge.h"
#include "contact/cells.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "io/case/rig_keys.h"
#include "io/keys/toml_document.h"
#include "io/results/output.h"
#include "mdr/settings.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Cells;
using Boundary = bem::Settings;
using Elements = fem::Settings;
using Vtk = Output::Vtk;
using Volume = Output::Volume;

std::vector<Choice> model_choices() {
    std::vector<Choice> choices;
    for (const auto& model : contact::model_kinds()) choices.push_back({model.name});
    return choices;
}

std::vector<CaseKey> top_keys() {
    return {
        {text_key("title", R"("Sphere on rubber")", "what the case is", {.default_value = "\"\""}),
         at<&Case::title>},
        {list_of(choice_key("models", model_choices(), R"(["mdr", "bem"])",
                            "models that compute the case", {.required = true})),
         at<&Case::models>}};
}

std::vector<CaseKey> model_keys() {
    return {
        {number_key("bem.cells_per_radius", {2, 4096}, "22.5", "cells in Hertz' contact radius",
                    {.default_value = "22.5", .alternative = cell_size}),
         kept<&Cells::per_radius>},
        {length_key("bem.spacing", R"("0.2 mm")", "edge length of a cell",
                    {.alternative = cell_size}),
         kept<&Cells::spacing>},
        {number_key("bem.cell_ratio", {0.01, 100}, "2.5",
                    "side of a cell along y over that along x; 1 without it"),
         kept<&Cells::ratio>},
        {number_key("bem.cell_shift_x", {-0.5, 0.5}, "0.5",
                    "centre of a cell, from the body's lowest point, over its side along x; 0 "
                    "without it"),
         kept<&Cells::shift_x>},
        {number_key("bem.cell_shift_y", {-0.5, 0.5}, "0.5", "the same along y"),
         kept<&Cells::shift_y>},
        {number_key("bem.tolerance", {1e-14, 1e-2, false, true}, "1e-7",
                    "relative tolerance of the solvers", {.default_value = "1e-07"}),
         kept<&Boundary::tolerance>},
        {text_key("bem.influence", R"("influence.txt")",
                  "file of influence coefficients to be used instead of those of the "
                  "program's own bodies"),
         kept<&Boundary::influence>},
        {choice_key("bem.adhesive_edge",
                    {choice("ring", contact::AdhesiveEdge::Kind::ring),
                     choice("cell", contact::AdhesiveEdge::Kind::cell)},
                    R"("cell")",
                    "how the edge of a contact that adheres without a range lets go: \"ring\": a "
                    "tension over a ring of cells stands for it; \"cell\", of "
                    "adhesion.approach_work = 0: cells one by one under (E* w/(0.473201 h))^(1/2) "
                    "(Pohrt and Popov 2015), for bem alone",
                    {.default_value = R"("ring")", .needs = "adhesion.work"}),
         [](Case& c) { return c.adhesion ? kept<&contact::AdhesiveEdge::kind>(c) : Field(); }},
        {length_key("bem.period", R"("80 mm")",
                    "period of indenters and tractions in x and y, for bem-layer, and for "
                    "bem under nominally flat bodies; without it there is one indenter"),
         at<&Case::period>},
        {integer_key("mdr.springs", {10, 1e7}, "10000",
                     "springs of the whole bed, contact and rolling path",
                     {.default_value = "10000"}),
         kept<&mdr::Settings::springs>},
        {integer_key("mdr.elements_per_radius", {5, 1000}, "100",
                     "elements in the contact radius of mdr-layer, shorter ones where the layer is "
                     "thin, and of mdr on an elastic interface",
                     {.default_value = "100"}),
         kept<&mdr::Settings::elements_per_radius>},
        {number_key("fem.accuracy", {1e-5, 0.2, false, true}, "0.01",
                    "relative accuracy of the normal contact; the size is chosen for it",
                    {.default_value = "0.01", .alternative = element_size}),
         kept<&Elements::accuracy>},
        {length_key("fem.size", R"("0.5 mm")", "edge of an element in the contact patch",
                    {.alternative = element_size}),
         kept<&Elements::size>},
        {text_key("fem.mesh", R"("layer.msh")",
                  "gmsh file to be used instead of a mesh of the program's own",
                  {.alternative = element_size}),
         kept<&Elements::mesh>},
        {length_key("fem.mesh_unit", R"("1 mm")", "length of 1 in that file",
                    {.default_value = R"("1 m")", .needs = "fem.mesh"}),
         [](Case& c) {
             return c.of<fem::Settings>().mesh ? Field(&c.of<fem::Settings>().mesh_unit) : Field();
         }},
        {number_key("fem.growth", {1.05, 3}, "1.8",
                    "ratio of neighbouring elements outwards from the contact patch",
                    {.default_value = "1.8"}),
         kept<&Elements::growth>},
        {choice_key(
             "fem.sides", {choice("free", fem::Sides::free), choice("fixed", fem::Sides::fixed)},
             R"("free")", "how the sides of the block are held", {.default_value = R"("free")"}),
         kept<&Elements::sides>},
        {choice_key("fem.solver",
                    {choice("auto", fem::Solver::automatic), choice("direct", fem::Solver::direct),
                     choice("iterative", fem::Solver::iterative)},
                    R"("auto")",
                    "how displacements are solved for: by a factor; by iteration, which takes a "
                    "tenth of the memory; auto: by a factor where its memory is there",
                    {.default_value = R"("auto")"}),
         kept<&Elements::solver>},
        {number_key("fem.tolerance", {1e-14, 1e-2, false, true}, "1e-6",
                    "relative tolerance of the contact solvers", {.default_value = "1e-06"}),
         kept<&Elements::tolerance>},
        {text_key("fem.cache", R"("condensed")",
                  "folder that keeps condensed layers for later runs; `\"\"`: that of "
                  "the user, `\"none\"`: nothing is kept",
                  {.default_value = "\"\""}),
         kept<&Elements::cache>},
        {choice_key("output.vtk",
                    {choice("none", Vtk::none), choice("quarters", Vtk::quarters),
                     choice("frames", Vtk::frames), choice("all", Vtk::all)},
                    R"("frames")",
                    "surfaces written for ParaView: none; the loaded contact and each quarter "
                    "period; pressing, loading and frames_per_period; all steps",
                    {.default_value = R"("frames")"}),
         kept<&Output::vtk>},
        {integer_key("output.frames_per_period", {4, 10000}, "40",
                     "at most, of the steps that are computed: by turning points four; of a "
                     "prescribed path: from row to row; of rolling on: in each half length a of "
                     "the way",
                     {.default_value = "40"}),
         [](Case& c) {
             return c.of<Output>().vtk == Vtk::frames ? Field(&c.of<Output>().frames_per_period)
                                                      : Field();
         }},
        {choice_key("output.volume",
                    {choice("none", Volume::none), choice("last", Volume::last),
                     choice("quarters", Volume::quarters)},
                    R"("last")",
                    "interior written for ParaView where a model computes it: none, the last "
                    "state, each quarter period",
                    {.default_value = R"("none")"}),
         kept<&Output::volume>},
        {length_key("output.volume_depth", R"("10 mm")",
                    "how deep the volumes of bem and bem-layer reach, at most through the "
                    "layers; without it 3 contact radii (Hertz)"),
         kept<&Boundary::volume_depth>}};
}

}  // namespace

const std::vector<CaseKey>& case_keys() {
    static const std::vector<CaseKey> keys = [] {
        std::vector<CaseKey> all;
        for (auto* const part :
             {top_keys, indenter_keys, substrate_keys, upper_plate_keys, relaxation_keys, heat_keys,
              contact_keys, adhesion_keys, load_keys, rolling_keys, tractive_keys, path_keys,
              wear_keys, model_keys, rig_stiffness_keys})
            std::ranges::move(part(), std::back_inserter(all));
        return all;
    }();
    return keys;
}

const KeyList& case_key_list() {
    static const KeyList list(case_keys(), "docs/reference/case-file.md");
    return list;
}

const KeyList& case_file_keys() {
    static const KeyList list = with_rig_keys(case_key_list(), rolling_rig_keys());
    return list;
}

const CaseKey* find_key(std::string_view path) {
    return static_cast<const CaseKey*>(case_key_list().find(path));
}

bool is_section(std::string_view name) {
    return case_file_keys().has_section(name) || is_read_elsewhere(name);
}

double* number_of(const CaseKey& key, contact::Case& c) {
    const Field field = place_of(key, c);
    if (auto* const* value = std::get_if<double*>(&field)) return *value;
    if (auto* const* value = std::get_if<std::optional<double>*>(&field))
        return *value && **value ? &***value : nullptr;
    return nullptr;
}

}  // namespace tricontact::io

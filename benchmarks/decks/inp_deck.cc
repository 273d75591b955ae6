#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "benchmarks/decks/contact_mesh.h"
#include "benchmarks/decks/deck_family.h"
#include "benchmarks/decks/inp_text.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

struct InpElement {
    const char* name;
    DeckModel::Shape shape;
    bool is_quadratic;
};
// The first of each shape is the usual one.
constexpr InpElement inp_elements[]{
    {"CAX8R", DeckModel::Shape::axisymmetric, true}, {"CAX8", DeckModel::Shape::axisymmetric, true},
    {"CAX4", DeckModel::Shape::axisymmetric, false}, {"CPE8R", DeckModel::Shape::plane, true},
    {"CPE8", DeckModel::Shape::plane, true},         {"CPE4", DeckModel::Shape::plane, false},
    {"C3D8", DeckModel::Shape::half, false},         {"C3D20R", DeckModel::Shape::half, true},
    {"C3D20", DeckModel::Shape::half, true}};

const InpElement& inp_element(const DeckModel& model, const std::string& wish) {
    std::string names;
    for (const InpElement& element : inp_elements) {
        if (element.shape != model.shape) continue;
        if (wish.empty() || wish == element.name) return element;
        names += (names.empty() ? "" : ", ") + std::string(element.name);
    }
    throw contact::InputError("deck: elements " + wish + " are none of this deck; choose of " +
                              names);
}

using Out = std::back_insert_iterator<std::string>;

InpInteraction interaction_of(const DeckModel& model) {
    // The peak pressure, of which K was made, times mu over the stick slope.
    const double slip = model.mu > 0 ? model.mu * model.stiffness * model.depth_scale /
                                           (stiffness_factor * model.stick_slope)
                                     : 0;
    return {model.stiffness, model.mu, model.stick_slope, slip};
}

// All nodes of the indenter move along a loaded direction as NDEPTH does.
void write_followers(std::string& text, const DeckModel& model, const DeckMesh& mesh) {
    const auto found = mesh.node_sets.find("NDEPTH");
    if (found == mesh.node_sets.end()) return;
    const int leader = found->second.front(), up = model.shape == DeckModel::Shape::half ? 3 : 2;
    text += "*EQUATION\n";
    for (const int direction : {1, up}) {
        if (direction == 1 ? !model.has_tangential_force() : !model.has_force()) continue;
        for (const int node : mesh.node_sets.at("NIND"))
            if (node != leader)
                fmt::format_to(std::back_inserter(text), "2\n{},{},1.,{},{},-1.\n", node + 1,
                               direction, leader + 1, direction);
    }
}

void write_supports(Out out, const DeckModel& model) {
    const bool is_spatial = model.shape == DeckModel::Shape::half;
    fmt::format_to(out, "*BOUNDARY\nNBASE, {}, {}\n", model.has_sliding_base ? 2 : 1,
                   is_spatial ? 3 : 2);
    if (is_spatial)
        fmt::format_to(out, "NSYM, 2, 2\n");
    else if (!model.is_shifted())
        fmt::format_to(out, "NAXIS, 1, 1\n");
}

// Normal and tangential control of a step: displacements of all nodes of the indenter, or of the
// node NDEPTH that they follow, or forces on those.
void write_control(Out out, const DeckModel& model, const DeckStep& step, bool is_first) {
    const int up = model.shape == DeckModel::Shape::half ? 3 : 2;
    std::string loads, pressures;
    fmt::format_to(out, "*BOUNDARY\n");
    if (up == 3) fmt::format_to(out, "NIND, 2, 2\n");
    const char* shifted = model.has_tangential_force() ? "NDEPTH" : "NIND";
    if (step.is_tangential_force)
        loads += fmt::format("NDEPTH, 1, {:.9g}\n", model.share() * step.shift);
    else
        fmt::format_to(out, "{}, 1, 1, {:.9g}\n", shifted, step.shift);
    if (step.is_force && model.loaded_area > 0)
        pressures = fmt::format("SLOAD, P, {:.9g}\n", step.normal / model.loaded_area);
    else if (step.is_force)
        loads += fmt::format("NDEPTH, {}, {:.9g}\n", up, -model.share() * step.normal);
    else
        fmt::format_to(out, "{}, {}, {}, {:.9g}\n", model.has_force() ? "NDEPTH" : "NIND", up, up,
                       -step.normal);
    const char* instead = is_first ? "" : ", OP=NEW";
    if (!loads.empty()) fmt::format_to(out, "*CLOAD{}\n{}", instead, loads);
    if (!pressures.empty()) fmt::format_to(out, "*DSLOAD{}\n{}", instead, pressures);
}

void write_steps(std::string& text, const DeckModel& model, bool is_abaqus) {
    const Out out = std::back_inserter(text);
    for (std::size_t i = 0; i < model.steps.size(); ++i) {
        const DeckStep& step = model.steps[i];
        fmt::format_to(out, "** step {}: {} {:.9g}, {} {:.9g}\n", i + 1,
                       step.is_force ? "force" : "depth", step.normal,
                       step.is_tangential_force ? "tangential force" : "shift", step.shift);
        // A frictionless contact is pressed in five increments too: it converges more surely.
        const int increments = std::max(step.increments, i == 0 ? 5 : 1);
        fmt::format_to(out, "*STEP, INC=1000{}\n*STATIC\n{:.9g}, 1., 1e-6, {:.9g}\n",
                       is_abaqus ? ", NLGEOM=NO" : "", 1. / increments, 1. / increments);
        if (model.presses_frictionless && i == 1) {
            text += "*CHANGE FRICTION, INTERACTION=CONTACT\n";
            write_inp_friction(text, interaction_of(model), is_abaqus);
        }
        write_control(out, model, step, i == 0);
        write_inp_output(text, {"NIND", "NBASE"}, model.has_force() ? "NDEPTH" : "", is_abaqus);
        fmt::format_to(out, "*END STEP\n");
    }
}

// CalculiX has no contact on faces that touch the axis of revolution, where its elements
// degenerate.
constexpr double beside_axis = 2.5e-5;  // in a

void move_off_axis(DeckMesh& mesh, double distance) {
    for (DeckMesh::Point& p : mesh.nodes)
        if (p[0] == 0) p[0] = distance;
}

std::string inp_text(const DeckModel& model, const InpElement& element, int n, int level,
                     bool is_abaqus) {
    DeckMesh mesh = bodies_of(model, n, level, element.is_quadratic);
    if (model.shape == DeckModel::Shape::axisymmetric) move_off_axis(mesh, beside_axis * model.a);
    volume_of(mesh, 0, mesh.n_elements());
    std::string text;
    const Out out = std::back_inserter(text);
    fmt::format_to(out, "*HEADING\n{}, {} elements in the contact radius {:.9g} mm; mm, N, MPa\n",
                   model.name, n << level, model.a);
    write_inp_mesh(text, mesh, element.name);
    const bool is_plane = model.shape == DeckModel::Shape::plane;
    fmt::format_to(out, "*MATERIAL, NAME=BODY\n*ELASTIC\n{:.12g}, {:.12g}\n", model.young,
                   model.poisson);
    // A rigid indenter's nodes all move alike; its material does not matter.
    const auto [young, poisson] = model.upper ? std::pair{model.upper->young, model.upper->poisson}
                                              : std::pair{1e3 * model.young, .3};
    fmt::format_to(out, "*MATERIAL, NAME=INDENTER\n*ELASTIC\n{:.12g}, {:.12g}\n", young, poisson);
    const char* section = is_plane ? "1.\n" : "";
    fmt::format_to(out, "*SOLID SECTION, ELSET=EBODY, MATERIAL=BODY\n{}", section);
    fmt::format_to(out, "*SOLID SECTION, ELSET=EIND, MATERIAL=INDENTER\n{}", section);
    InpInteraction interaction = interaction_of(model);
    // A step can change friction alone, not begin it.
    if (model.presses_frictionless) interaction.mu = 1e-6;
    write_inp_contact(text, interaction, is_abaqus);
    write_followers(text, model, mesh);
    write_supports(out, model);
    write_steps(text, model, is_abaqus);
    return text;
}

}  // namespace

DeckFamily inp_family(const DeckModel& model, const DeckWishes& wishes, bool is_abaqus) {
    const InpElement& element = inp_element(model, wishes.elements);
    DeckFamily family;
    family.code = is_abaqus ? "Abaqus" : "CalculiX 2.20";
    family.elements = element.name;
    family.method = "penalty";
    family.kinematics = "displaced";
    family.has_stiffness = true;
    if (is_abaqus)
        family.remarks.push_back(
            "The input was not tried with Abaqus: mesh and steps are those of the input for "
            "CalculiX, "
            "which was; friction's elastic slip and the output follow Abaqus' manual. Save r (or "
            "x, y) "
            "and CPRESS of SLAYER as columns of the CSV files that submission.toml names.");
    if (model.shape == DeckModel::Shape::axisymmetric)
        family.remarks.push_back(fmt::format(
            "Nodes of the axis are at r = {:.3g} mm: CalculiX has no contact on faces that touch "
            "the axis of revolution.",
            beside_axis * model.a));
    const bool is_spatial = model.shape == DeckModel::Shape::half;
    if (is_spatial)
        family.remarks.push_back(
            "Times of the shifted layer with CalculiX 2.20, C3D8, one thread: 5 s at n = 3 and 68 "
            "s "
            "at n = 6, both measured. Extrapolated by their ratio n = 12 takes a quarter of an "
            "hour, at the least: memory and time of the direct solver grow faster; a mesh of n = 8 "
            "did not end within half an hour on a loaded machine. n = 12 was not run.");
    const int coarsest = coarsest_elements(model);
    for (int level = 0; level < levels_of(model, wishes); ++level) {
        const std::string job = add_run(family, model);
        DeckRun& run = family.runs.back();
        run.files.push_back({job + ".inp", inp_text(model, element, coarsest, level, is_abaqus)});
        run.command = is_abaqus ? "abaqus interactive job=" + job : "ccx " + job;
        run.field = job + (is_abaqus ? ".csv" : ".frd");
        run.set = is_abaqus ? "" : "BODY";  // as the file names it: by its material
        run.totals = is_abaqus ? "" : job + ".dat";
    }
    return family;
}

}  // namespace tricontact::benchmarks

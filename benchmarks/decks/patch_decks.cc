#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "benchmarks/decks/closed_families.h"
#include "benchmarks/decks/deck_mesh.h"
#include "benchmarks/decks/graded_line.h"
#include "benchmarks/decks/inp_text.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

using Point = DeckMesh::Point;

std::vector<double> equal_line(double start, double end, int count) {
    return graded_line(start, (end - start) / count, count, end, 2);
}

// Elements of plane strain, of both bodies; only inputs of Abaqus' kind have two bodies.
std::string plane_elements(const DeckWishes& wishes, const std::string& problem) {
    if (wishes.code != "calculix" && wishes.code != "abaqus")
        throw contact::InputError("deck: " + problem + " has no deck for " + wishes.code +
                                  ": two bodies in contact; choose of calculix, abaqus");
    const std::string element = wishes.elements.empty() ? "CPE4" : wishes.elements;
    if (element != "CPE4" && element != "CPE8" && element != "CPE8R")
        throw contact::InputError("deck: elements " + element + " are none of " + problem +
                                  "; choose of CPE4, CPE8, CPE8R");
    return element;
}

// Two blocks, the lower one's upper surface and the upper one's lower surface in contact.
struct TwoBlocks {
    BlockLines lower, upper;
    double slope = 0;  ///< of the surfaces in contact [-]
};

DeckMesh two_blocks(const TwoBlocks& blocks, bool is_quadratic) {
    DeckMesh mesh;
    mesh.is_quadratic = is_quadratic;
    const auto named = [](const BlockLines& lines, const std::string& name) {
        const double left = lines.x.front(), right = lines.x.back(), bottom = lines.y.front(),
                     top = lines.y.back();
        return std::vector<BlockSet>{
            {name + "BASE", [=](const Point& p) { return p[1] == bottom; }},
            {name + "TOP", [=](const Point& p) { return p[1] == top; }},
            {name + "LEFT", [=](const Point& p) { return p[0] == left; }},
            {name + "RIGHT", [=](const Point& p) { return p[0] == right; }}};
    };
    // Inclined where the blocks touch, level at the far ends.
    const auto inclined = [&](const BlockLines& lines, bool is_lower) {
        const double bottom = lines.y.front(), top = lines.y.back(), slope = blocks.slope;
        return [=](Point p) {
            const double share = (is_lower ? p[1] - bottom : top - p[1]) / (top - bottom);
            p[1] += share * slope * p[0];
            return p;
        };
    };
    add_block(mesh, blocks.lower, inclined(blocks.lower, true), named(blocks.lower, "L"));
    mesh.n_body_elements = mesh.n_elements();
    add_block(mesh, blocks.upper, inclined(blocks.upper, false), named(blocks.upper, "U"));
    const int n_lower = static_cast<int>(blocks.lower.x.size()) - 1,
              n_upper = static_cast<int>(blocks.upper.x.size()) - 1;
    // The upper block slides on the lower one: it is the slave, as the layer of other decks is.
    for (int e = mesh.n_body_elements; e < mesh.n_body_elements + n_upper; ++e)
        mesh.surfaces["SLAYER"].push_back({e, 1});
    for (int e = mesh.n_body_elements - n_lower; e < mesh.n_body_elements; ++e)
        mesh.surfaces["SIND"].push_back({e, 3});
    for (int e = mesh.n_elements() - n_upper; e < mesh.n_elements(); ++e)
        mesh.surfaces["SLOADED"].push_back({e, 3});
    volume_of(mesh, 0, mesh.n_elements());
    return mesh;
}

struct PatchProblem {
    std::string title;
    TwoBlocks (*blocks)(int n);
    double young, poisson;  ///< [MPa]
    InpInteraction interaction;
    std::string steps;  ///< with "@output@" in each
    std::string supports;
    std::vector<std::string> force_sets;
    std::string moved, readme;
};

std::string patch_inp(const PatchProblem& problem, const std::string& element, int n,
                      bool is_abaqus) {
    const DeckMesh mesh = two_blocks(problem.blocks(n), element != "CPE4");
    std::string text = fmt::format("*HEADING\n{}; mm, N, MPa\n", problem.title);
    write_inp_mesh(text, mesh, element);
    text += fmt::format("*MATERIAL, NAME=BODY\n*ELASTIC\n{:.12g}, {:.12g}\n", problem.young,
                        problem.poisson);
    for (const char* set : {"EBODY", "EIND"})
        text += fmt::format("*SOLID SECTION, ELSET={}, MATERIAL=BODY\n1.\n", set);
    write_inp_contact(text, problem.interaction, is_abaqus);
    text += problem.supports;
    std::string output, steps = problem.steps;
    write_inp_output(output, problem.force_sets, problem.moved, is_abaqus);
    const std::string mark = "@output@";
    for (std::size_t at = 0; (at = steps.find(mark, at)) != std::string::npos; at += output.size())
        steps.replace(at, mark.size(), output);
    return text + steps;
}

std::vector<DeckFile> patch_files(const PatchProblem& problem, const DeckWishes& wishes) {
    const std::string element = plane_elements(wishes, wishes.problem);
    const bool is_abaqus = wishes.code == "abaqus";
    std::vector<DeckFile> files;
    std::string commands;
    for (int level = 0; level < (wishes.levels > 0 ? wishes.levels : 3); ++level) {
        const std::string job = fmt::format("{}_n{}", wishes.problem, 4 << level);
        files.push_back({job + ".inp", patch_inp(problem, element, 4 << level, is_abaqus)});
        commands += fmt::format("    {}{}\n", is_abaqus ? "abaqus interactive job=" : "ccx ", job);
    }
    const std::string tried = is_abaqus ? "\nThe input was not tried with Abaqus: its mesh and its "
                                          "keywords follow the manual.\n"
                                        : "";
    files.push_back({"README.txt", problem.title + "\n\n" + problem.readme +
                                       "\nUnits: mm, N, MPa. Commands:\n\n" + commands + tried});
    return files;
}

TwoBlocks patch_blocks(int n) {
    // 4 on 3: no nodes in common but the ends, and none of two of these ratios.
    return {{equal_line(0, 1000, n), equal_line(0, 500, n / 2), {}},
            {equal_line(0, 1000, n / 4 * 3), equal_line(500, 1000, n / 2), {}},
            0};
}

TwoBlocks wedge_blocks(int n) {
    // The slope is longer: the block stays on it.
    return {{equal_line(-10, 60, n / 4 * 7), equal_line(-20, 0, n / 2), {}},
            {equal_line(0, 40, n), equal_line(0, 20, n / 2), {}},
            .1};
}

}  // namespace

std::vector<DeckFile> patch_test_deck(const DeckWishes& wishes) {
    return patch_files(
        {.title =
             "Patch test: two blocks of 1000 mm x 500 mm with meshes that do not match (Taylor "
             "and Papadopoulos 1991, SSNP121)",
         .blocks = patch_blocks,
         .young = 1,
         .poisson = 0,
         .interaction = {.stiffness = 10},
         .steps = "*STEP\n*STATIC\n1., 1.\n*BOUNDARY\nUTOP, 2, 2, -100.\n@output@*END STEP\n",
         .supports = "*BOUNDARY\nLBASE, 2, 2\nLLEFT, 1, 1\nULEFT, 1, 1\n",
         .force_sets = {"UTOP", "LBASE"},
         .moved = "UBASE",
         .readme =
             "The upper surface moves down by 100 mm, the lower one rests; E = 1 MPa, nu = 0, "
             "plane\n"
             "strain, penalty of 10 MPa/mm, no friction. Closed form: a uniform pressure of 0.1 "
             "MPa,\n"
             "100 N per mm of depth, at the interface a displacement of -50 mm. The penalty takes\n"
             "0.01 mm of the 100 mm: p = 0.09999 MPa. A formulation that passes has this pressure "
             "at\n"
             "every node and point of integration, on each of the meshes.\n"},
        wishes);
}

std::vector<DeckFile> wedge_deck(const DeckWishes& wishes) {
    return patch_files(
        {.title = "Wedge: a block of 40 mm x 20 mm is pushed up a slope of 0.1 with friction 0.3 "
                  "(NAFEMS CGS-4)",
         .blocks = wedge_blocks,
         .young = 210000,
         .poisson = .3,
         .interaction = {1e5, .3, 1e5, 7.5e-5},
         .steps = "*STEP\n*STATIC\n0.5, 1.\n*DSLOAD\nSLOADED, P, 25.\n@output@*END STEP\n"
                  "*STEP\n*STATIC\n0.25, 1.\n*BOUNDARY\nULEFT, 1, 1, 0.05\n@output@*END STEP\n",
         .supports = "*BOUNDARY\nLBASE, 1, 2\nULEFT, 1, 1\n",
         .force_sets = {"ULEFT", "LBASE"},
         .moved = "",
         .readme = "A pressure of 25 MPa on the upper surface stands for the weight, G = 1000 N "
                   "per mm of\n"
                   "depth; the left side is then pushed to the right, up the slope, by 0.05 mm, "
                   "far beyond\n"
                   "the elastic slip of 7.5e-5 mm. E = 210 GPa, nu = 0.3, plane strain, penalty "
                   "and stick\n"
                   "slope of 1e5 MPa/mm. Closed form while it slides:\n"
                   "F/G = (tan(alpha) + mu)/(1 - mu tan(alpha)) = 0.412371, so that the total "
                   "force of ULEFT\n"
                   "is 412.371 N and that of LBASE (-412.371, 1000) N, on each of the meshes.\n"
                   "CalculiX has 412.352 N: its slope is that of the displaced surface.\n"},
        wishes);
}

}  // namespace tricontact::benchmarks

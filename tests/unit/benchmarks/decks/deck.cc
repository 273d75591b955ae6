// Files of decks, read again without a solver.

#include "benchmarks/decks/deck.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "benchmarks/decks/closed_decks.h"
#include "contact/base/error.h"
#include "io/case/case_reader.h"

namespace tricontact::benchmarks::deck_test {
namespace {

const std::string pressed =
    "models = [\"mdr-layer\"]\n[indenter]\nradius = \"40 mm\"\n[substrate]\nyoung = \"5.2 MPa\"\n"
    "poisson = 0.3\nthickness = \"8 mm\"\n[friction]\ncoefficient = 0.57\n[contact]\ncoupling = "
    "false\n"
    "[load]\nindentation = \"0.35 mm\"\ntangential_ratio = 0.0\n";
const std::string shifted =
    "models = [\"bem-layer\"]\n[indenter]\nradius = \"40 mm\"\n[substrate]\nyoung = \"5.2 MPa\"\n"
    "poisson = 0.3\nthickness = \"8 mm\"\n[friction]\ncoefficient = 0.57\n[load]\npress_steps = 5\n"
    "[path]\ntable = \"\"\"\nindentation [mm], shift_x [mm], steps\n0.35, 0, 1\n0.35, 0.10, "
    "4\n\"\"\"\n";
const std::string cylinder =
    "models = [\"bem\"]\n[indenter]\nshape = \"cylinder\"\nradius = \"50 mm\"\nlength = \"1 m\"\n"
    "young = \"210 GPa\"\npoisson = 0.3\n[substrate]\nyoung = \"70 GPa\"\npoisson = "
    "0.3\n[friction]\n"
    "coefficient = 0.1\n[contact]\ncoupling = false\n[load]\nnormal_force = \"35 MN\"\n"
    "tangential_ratio = 0.0\n";

// The case and what the deck takes from its reference: radius and peak pressure of the literature.
Reference reference_of(const std::string& text, double radius, double depth, double peak,
                       Geometry geometry) {
    Reference reference;
    reference.c = io::parse_case(text, "case");
    reference.contact_radius = radius;
    reference.geometry = geometry;
    if (depth > 0) reference.values["indentation"] = {.value = depth};
    reference.values["peak_pressure"] = {.value = peak};
    return reference;
}
Reference pressed_layer() {
    return reference_of(pressed, 4.334e-3, .35e-3, .421046e6, Geometry::axisymmetric);
}
Reference shifted_layer() {
    return reference_of(shifted, 4.3e-3, .35e-3, .43e6, Geometry::spatial);
}
Reference pressed_cylinder() {
    return reference_of(cylinder, 6.2156e-3, 0, 3585.4e6, Geometry::plane);
}

std::string text_of(const std::vector<DeckFile>& files, const std::string& name) {
    const auto found = std::ranges::find(files, name, &DeckFile::name);
    return found == files.end() ? "" : found->text;
}

std::string refusal(const Reference& reference, const DeckWishes& wishes) {
    try {
        write_deck(reference, wishes);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "";
}

// What a reader of such inputs takes from them.
struct Input {
    std::map<int, std::vector<double>> nodes;
    std::map<int, std::vector<int>> elements;
    std::map<std::string, std::set<int>> node_sets;
    std::map<std::string, std::vector<int>> surfaces;  ///< elements
    std::map<std::string, int> keywords;
    std::map<std::string, std::vector<std::string>> lines;  ///< of the last one of a keyword
};

std::vector<double> numbers_of(const std::string& line) {
    std::vector<double> numbers;
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
        cell.erase(0, cell.find_first_not_of(' '));
        double value = 0;
        if (std::from_chars(cell.data(), cell.data() + cell.size(), value).ec == std::errc{})
            numbers.push_back(value);
    }
    return numbers;
}

std::string option(const std::string& keyword, const std::string& name) {
    const auto at = keyword.find(name + "=");
    if (at == std::string::npos) return "";
    return keyword.substr(at + name.size() + 1, keyword.find(',', at) - at - name.size() - 1);
}

Input read_input(const std::string& text) {
    Input input;
    std::stringstream stream(text);
    std::string keyword;
    std::vector<int> element;
    for (std::string line; std::getline(stream, line);) {
        EXPECT_LE(line.size(), 132u) << "longer than a line of CalculiX";
        if (line.starts_with("**")) continue;
        if (line.starts_with('*')) {
            keyword = line;
            const std::string word = line.substr(0, line.find(','));
            ++input.keywords[word];
            input.lines[word].clear();
            continue;
        }
        const std::vector<double> numbers = numbers_of(line);
        const std::string word = keyword.substr(0, keyword.find(','));
        input.lines[word].push_back(line);
        EXPECT_LE(numbers.size(), 16u);
        if (word == "*NODE" && keyword.starts_with("*NODE, NSET=NALL"))
            input.nodes[static_cast<int>(numbers[0])] = {numbers.begin() + 1, numbers.end()};
        if (word == "*ELEMENT") {
            for (const double number : numbers) element.push_back(static_cast<int>(number));
            if (line.back() == ',') continue;
            input.elements[element[0]] = {element.begin() + 1, element.end()};
            element.clear();
        }
        if (word == "*NSET")
            for (const double node : numbers)
                input.node_sets[option(keyword, "NSET")].insert(static_cast<int>(node));
        if (word == "*SURFACE")
            input.surfaces[option(keyword, "NAME")].push_back(static_cast<int>(numbers[0]));
    }
    return input;
}

TEST(Deck, FamilyOfThePressedLayer) {
    const auto files =
        write_deck(pressed_layer(), {.code = "calculix", .problem = "layer_pressed"});
    ASSERT_EQ(files.size(), 6u);
    std::size_t elements = 0;
    std::set<std::vector<double>> coarse;
    for (const int n : {4, 8, 16, 32}) {
        const Input input =
            read_input(text_of(files, "layer_pressed_n" + std::to_string(n) + ".inp"));
        std::set<std::vector<double>> places;
        for (const auto& [node, place] : input.nodes)
            if (!input.node_sets.at("NIND").contains(node)) places.insert(place);
        // The edge of the contact is a node of the surface, and half elements beside it.
        EXPECT_TRUE(places.contains({4.334, 0})) << n;
        EXPECT_TRUE(std::ranges::any_of(places, [&](const auto& p) {
            return p[1] == 0 && std::abs(p[0] - 4.334 + 4.334 / n / 2) < 1e-8;
        })) << n;
        // Nested: a node of the coarser mesh is one of this, to the digits of the file.
        for (const auto& place : coarse)
            EXPECT_TRUE(std::ranges::any_of(places, [&](const auto& p) {
                return std::abs(p[0] - place[0]) + std::abs(p[1] - place[1]) < 1e-7;
            }));
        if (n <= 8) coarse = places;
        const std::size_t body = std::ranges::count_if(input.elements, [&](const auto& element) {
            return !input.node_sets.at("NIND").contains(element.second[0]);
        });
        EXPECT_TRUE(elements == 0 || body == 4 * elements);
        elements = body;
        for (const auto& [number, element] : input.elements) {
            EXPECT_EQ(element.size(), 8u);
            for (const int node : element) EXPECT_TRUE(input.nodes.contains(node));
        }
        // The block: 48 mm, 8 mm.
        EXPECT_TRUE(places.contains({48, -8}));
        EXPECT_EQ(input.lines.at("*SURFACE BEHAVIOR"), std::vector<std::string>{"260"});
        EXPECT_EQ(input.surfaces.at("SLAYER").size(), static_cast<std::size_t>(n * 3 / 2));
        EXPECT_FALSE(input.keywords.contains("*FRICTION"));
    }
}

TEST(Deck, IndenterLiesOnItsProfile) {
    const auto files = write_deck(pressed_layer(), {.code = "calculix", .problem = "p"});
    const Input input = read_input(text_of(files, "p_n4.inp"));
    int on_profile = 0;
    for (const int node : input.node_sets.at("NIND")) {
        const auto& p = input.nodes.at(node);
        on_profile += std::abs(p[1] - p[0] * p[0] / 80) < 1e-7;
    }
    // Corners and middles of its lower surface, out to 2 a.
    EXPECT_EQ(on_profile, 17);
}

TEST(Deck, SubmissionNamesWhatTheRunsWrite) {
    for (const auto& [code, ending] :
         {std::pair{"calculix", ".frd"}, {"freefem", ".csv"}, {"getfem", ".csv"}}) {
        const auto files = write_deck(pressed_layer(), {.code = code, .problem = "layer_pressed"});
        const std::string submission = text_of(files, "submission.toml"),
                          readme = text_of(files, "README.txt");
        EXPECT_NE(submission.find("case = \"layer_pressed\""), std::string::npos);
        for (const char* n : {"n4", "n8", "n16", "n32"})
            EXPECT_NE(submission.find(std::string("field = \"layer_pressed_") + n + ending + "\""),
                      std::string::npos)
                << submission;
        EXPECT_NE(readme.find("tricontact benchmark compare submission.toml"), std::string::npos);
        EXPECT_NE(readme.find("0.35 mm"), std::string::npos);
    }
}

TEST(Deck, ScriptsHaveTheEdgeAtANode) {
    for (const char* code : {"freefem", "getfem"}) {
        const auto files = write_deck(pressed_layer(), {.code = code, .problem = "p"});
        const std::string text = files.front().text;
        EXPECT_NE(text.find("3.2505, 4.334, 5.4175"), std::string::npos) << text;
        EXPECT_NE(text.find("csv"), std::string::npos);
    }
}

TEST(Deck, AbaqusHasOutputOfItsOwn) {
    const DeckWishes calculix{.code = "calculix", .levels = 1, .problem = "p"},
        abaqus{.code = "abaqus", .levels = 1, .problem = "p"};
    const Input ours = read_input(text_of(write_deck(shifted_layer(), calculix), "p_n3.inp")),
                theirs = read_input(text_of(write_deck(shifted_layer(), abaqus), "p_n3.inp"));
    EXPECT_EQ(ours.nodes, theirs.nodes);
    EXPECT_EQ(ours.elements, theirs.elements);
    EXPECT_EQ(ours.node_sets, theirs.node_sets);
    EXPECT_TRUE(theirs.keywords.contains("*CONTACT OUTPUT"));
    EXPECT_FALSE(theirs.keywords.contains("*CONTACT FILE"));
    EXPECT_FALSE(ours.keywords.contains("*CONTACT OUTPUT"));
    std::string readme = text_of(write_deck(shifted_layer(), abaqus), "README.txt");
    std::ranges::replace(readme, '\n', ' ');
    EXPECT_NE(readme.find("not tried with Abaqus"), std::string::npos);
}

TEST(Deck, HalfModelOfTheShiftedLayer) {
    const auto files =
        write_deck(shifted_layer(), {.code = "calculix", .levels = 1, .problem = "p"});
    const Input input = read_input(text_of(files, "p_n3.inp"));
    for (const int node : input.node_sets.at("NSYM")) EXPECT_EQ(input.nodes.at(node)[1], 0);
    EXPECT_EQ(input.keywords.at("*STEP"), 2);
    EXPECT_EQ(input.lines.at("*FRICTION").front().substr(0, 5), "0.57,");
    std::string readme = text_of(files, "README.txt");
    std::ranges::replace(readme, '\n', ' ');
    EXPECT_NE(readme.find("twice as much"), std::string::npos);
}

TEST(Deck, ForceOfACylinderActsOnAMillimetre) {
    const auto files =
        write_deck(pressed_cylinder(), {.code = "calculix", .levels = 1, .problem = "c"});
    const Input input = read_input(text_of(files, "c_n4.inp"));
    // Half of 35 kN/mm.
    EXPECT_EQ(input.lines.at("*CLOAD"), std::vector<std::string>{"NDEPTH, 2, -17500"});
    EXPECT_TRUE(input.keywords.contains("*EQUATION"));
    // The body has the effective modulus of both: E = 0.91 E*, 1/E* = 0.91/210 + 0.91/70 (GPa).
    const std::string text = text_of(files, "c_n4.inp");
    EXPECT_NE(text.find("NAME=BODY\n*ELASTIC\n52500, 0.3\n"), std::string::npos);
}

TEST(Deck, WhatADeckCannotHaveIsRefused) {
    EXPECT_NE(refusal(shifted_layer(), {.code = "freefem"}).find("frictionless"),
              std::string::npos);
    EXPECT_NE(refusal(shifted_layer(), {.code = "getfem"}).find("GetFEM"), std::string::npos);
    EXPECT_NE(refusal(pressed_layer(), {.code = "ansys"}).find("choose of calculix"),
              std::string::npos);
    EXPECT_NE(refusal(pressed_layer(), {.code = "calculix", .elements = "C3D8"}).find("CAX8R"),
              std::string::npos);
    EXPECT_NE(refusal(pressed_layer(), {.code = "freefem", .elements = "Q2"}).find("P2, P1"),
              std::string::npos);
    Reference rolling = pressed_layer();
    rolling.c.rolling.emplace();
    EXPECT_NE(refusal(rolling, {.code = "calculix"}).find("rolling"), std::string::npos);
    Reference rubber = pressed_layer();
    rubber.c.law = contact::Case::Law::neo_hookean;
    EXPECT_NE(refusal(rubber, {.code = "calculix"}).find("finite strains"), std::string::npos);
}

TEST(Deck, MeshesForOtherCodes) {
    const auto files = write_deck(pressed_layer(), {.code = "mesh", .levels = 1, .problem = "p"});
    const std::string msh = text_of(files, "p_n4.msh"), vtu = text_of(files, "p_n4.vtu");
    for (const char* part : {"base", "side", "contact", "axis"}) {
        EXPECT_NE(msh.find("\"" + std::string(part) + "\""), std::string::npos);
        EXPECT_NE(vtu.find("Name=\"" + std::string(part) + "\""), std::string::npos);
    }
    EXPECT_TRUE(msh.starts_with("$MeshFormat\n4.1 0 8\n"));
    EXPECT_NE(vtu.find("NumberOfCells=\"48\""), std::string::npos);
}

TEST(Deck, GetfemPressesWithFriction) {
    std::string text = pressed;
    text.replace(text.find("mdr-layer"), 9, "bem-layer");
    text.replace(text.find("coupling = false"), 16, "coupling = true");
    text.replace(text.find("tangential_ratio = 0.0"), 22,
                 "tangential_ratio = 0.0\npress_steps = 5");
    const Reference reference = reference_of(text, 4.31e-3, .35e-3, .426e6, Geometry::axisymmetric);
    const std::string script =
        write_deck(reference, {.code = "getfem", .levels = 1, .problem = "p"}).front().text;
    EXPECT_NE(script.find("np.linspace(0, 0.35, 5 + 1)"), std::string::npos) << script;
    EXPECT_NE(script.find("'friction', 0.57"), std::string::npos);
    EXPECT_NE(refusal(reference, {.code = "freefem"}).find("frictionless"), std::string::npos);
}

TEST(ClosedDeck, AllProblems) {
    for (const char* name : {"patch_test", "wedge", "complete_punch", "rounded_punch_plane",
                             "pin_in_hole", "receding_layer", "nafems_roller", "nafems_punch"}) {
        EXPECT_TRUE(has_closed_deck(name));
        const auto files = write_closed_deck({.code = "calculix", .problem = name});
        EXPECT_EQ(text_of(files, "submission.toml"), "");
        EXPECT_NE(text_of(files, "README.txt").find("losed form"), std::string::npos) << name;
        read_input(files.front().text);
    }
    EXPECT_FALSE(has_closed_deck("layer_pressed"));
    EXPECT_THROW(write_closed_deck({.code = "freefem", .problem = "wedge"}), contact::InputError);
    EXPECT_THROW(write_closed_deck({.code = "calculix", .problem = "other"}), contact::InputError);
}

TEST(ClosedDeck, PatchesDoNotMatch) {
    const auto files =
        write_closed_deck({.code = "calculix", .levels = 1, .problem = "patch_test"});
    const Input input = read_input(files.front().text);
    std::set<double> lower, upper;
    for (const auto& [node, p] : input.nodes)
        if (p[1] == 500) (input.node_sets.at("UBASE").contains(node) ? upper : lower).insert(p[0]);
    EXPECT_EQ(lower.size(), 5u);
    EXPECT_EQ(upper.size(), 4u);
}

// 100 MPa on the whole upper face: 785.398 kN. CalculiX has no contact on faces at the axis.
TEST(ClosedDeck, PunchIsPressedByAPressureAndStandsBesideTheAxis) {
    const auto files =
        write_closed_deck({.code = "calculix", .levels = 1, .problem = "nafems_punch"});
    EXPECT_NE(files.front().text.find("*DSLOAD\nSLOAD, P, 100\n"), std::string::npos);
    EXPECT_EQ(files.front().text.find("*CLOAD"), std::string::npos);
    for (const auto& [node, p] : read_input(files.front().text).nodes) EXPECT_GT(p[0], 0) << node;
    // Each body by itself, with what holds or loads it.
    const auto meshes = write_closed_deck({.code = "mesh", .levels = 1, .problem = "nafems_punch"});
    const std::string& upper_mesh = text_of(meshes, "nafems_punch_n4_upper.msh");
    for (const char* part : {"contact", "axis", "loaded"})
        EXPECT_NE(upper_mesh.find("\"" + std::string(part) + "\""), std::string::npos) << part;
    EXPECT_EQ(upper_mesh.find("\"base\""), std::string::npos);
    EXPECT_NE(text_of(meshes, "nafems_punch_n4_lower.vtu").find("Name=\"base\""),
              std::string::npos);
    // Both bodies, the script and README.txt; its pressure is that of the problem.
    const auto scripts =
        write_closed_deck({.code = "freefem", .levels = 1, .problem = "nafems_punch"});
    ASSERT_EQ(scripts.size(), 4u);
    EXPECT_NE(scripts[2].text.find("-weight*100*q"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::benchmarks::deck_test

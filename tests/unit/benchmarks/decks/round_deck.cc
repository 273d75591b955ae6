// Decks of half a ball or cylinder: the arc, the lattice, two bodies, what is refused.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <sstream>

#include "benchmarks/decks/closed_decks.h"
#include "benchmarks/decks/contact_mesh.h"
#include "benchmarks/decks/deck.h"
#include "benchmarks/problems/problem.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {
namespace round_deck_test {

constexpr double radius = 10;

/// The case of a problem with the radius of the literature.
Reference reference_of(const std::string& name, double a) {
    Reference reference;
    reference.c = required_problem(name).make_case();
    reference.contact_radius = a;
    reference.geometry = reference.c.is_line_contact() ? Geometry::plane : Geometry::axisymmetric;
    reference.values["indentation"] = {.value = 1e-4};
    reference.values["peak_pressure"] = {.value = .143057e6};
    return reference;
}
DeckModel model_of(const std::string& name) {
    return make_deck_model(reference_of(name, 1.0246e-3), {.code = "calculix", .problem = name});
}

bool is_near(double x, double y) {
    return std::abs(x - y) < 1e-9;
}

TEST(RoundDeck, NodesLieOnTheArcAndTheFlatFace) {
    const DeckModel model = model_of("hemisphere");
    for (const bool is_quadratic : {false, true}) {
        const DeckMesh mesh = block_mesh(model, 4, 1, is_quadratic);
        for (const int node : mesh.node_sets.at("NTOP")) {
            const auto& p = mesh.nodes[node];
            EXPECT_NEAR(std::hypot(p[0], p[1] + radius), radius, 1e-12);
        }
        for (const int node : mesh.node_sets.at("NBASE"))
            EXPECT_NEAR(mesh.nodes[node][1], -radius, 1e-12);
        for (const int node : mesh.node_sets.at("NAXIS")) EXPECT_EQ(mesh.nodes[node][0], 0);
        EXPECT_FALSE(mesh.node_sets.contains("NSIDE"));
        // The contact's edge, the pole and the rim are nodes.
        const auto has = [&](const std::string& set, double x, double z) {
            return std::ranges::any_of(mesh.node_sets.at(set), [&](int node) {
                return is_near(mesh.nodes[node][0], x) && is_near(mesh.nodes[node][1], z);
            });
        };
        EXPECT_TRUE(has("NCONTACT", 1.0246, std::sqrt(radius * radius - 1.0246 * 1.0246) - radius));
        EXPECT_TRUE(has("NCONTACT", 0, 0));
        EXPECT_TRUE(has("NTOP", radius, -radius));
    }
}

// Facets lack their segments of the disc, edges through middles nearly nothing.
TEST(RoundDeck, AreaIsThatOfAQuarterOfTheDisc) {
    const DeckModel model = model_of("hemisphere");
    const double quarter = std::numbers::pi * radius * radius / 4;
    const DeckMesh curved = block_mesh(model, 4, 1, true),
                   straight = block_mesh(model, 4, 1, false);
    EXPECT_NEAR(volume_of(curved, 0, curved.n_elements()), quarter, 2e-5 * quarter);
    const double area = volume_of(straight, 0, straight.n_elements());
    EXPECT_LT(area, quarter);
    EXPECT_NEAR(area, quarter, .01 * quarter);
}

TEST(RoundDeck, MeshesAreNested) {
    const DeckModel model = model_of("ball_between_plates");
    const DeckMesh coarse = block_mesh(model, 4, 0, false), fine = block_mesh(model, 4, 1, false);
    EXPECT_EQ(fine.n_elements(), 4 * coarse.n_elements());
    for (const auto& p : coarse.nodes)
        EXPECT_TRUE(std::ranges::any_of(
            fine.nodes, [&](const auto& q) { return is_near(p[0], q[0]) && is_near(p[1], q[1]); }));
}

TEST(RoundDeck, RigidPlanePressesTheBody) {
    const DeckModel model = model_of("hemisphere");
    DeckMesh mesh = block_mesh(model, 4, 0, true);
    add_indenter(mesh, model, 4, 0);
    for (const ElementFace& face : mesh.surfaces.at("SIND"))
        for (const int node : mesh.face_nodes(face)) EXPECT_EQ(mesh.nodes[node][1], 0);
    EXPECT_EQ(model.young, 2);
    EXPECT_EQ(model.poisson, .3);
    EXPECT_NEAR(model.steps.back().normal, .1, 1e-12);
}

// Its gap to the layer is that of the sphere, and both bodies have their own material.
TEST(RoundDeck, TwoBodies) {
    const DeckModel model = model_of("hemisphere_on_layer");
    DeckMesh mesh = block_mesh(model, 4, 0, true);
    const int n_body = mesh.n_elements();
    add_upper_body(mesh, model, 4, 0);
    EXPECT_GT(volume_of(mesh, n_body, mesh.n_elements()), .78 * radius * radius);
    double reach = 0;
    for (const ElementFace& face : mesh.surfaces.at("SIND"))
        for (const int node : mesh.face_nodes(face)) {
            const auto& p = mesh.nodes[node];
            EXPECT_NEAR(p[1], radius - std::sqrt(radius * radius - p[0] * p[0]), 1e-12);
            reach = std::max(reach, p[0]);
        }
    EXPECT_GT(reach, 1.45 * 1.0246);
    for (const int node : mesh.node_sets.at("NIND"))
        EXPECT_NEAR(mesh.nodes[node][1], radius, 1e-12);
    const auto files = write_deck(reference_of("hemisphere_on_layer", 1.0367e-3),
                                  {.code = "calculix", .levels = 1, .problem = "p"});
    EXPECT_NE(files.front().text.find("*MATERIAL, NAME=BODY\n*ELASTIC\n4, 0.3\n"),
              std::string::npos);
    EXPECT_NE(files.front().text.find("*MATERIAL, NAME=INDENTER\n*ELASTIC\n2, 0.3\n"),
              std::string::npos);
}

TEST(RoundDeck, PlatesLeaveTheMiddlePlaneFree) {
    const auto text = [](const std::string& name, const std::string& code) {
        return write_deck(reference_of(name, 1.0246e-3),
                          {.code = code, .levels = 1, .problem = name})
            .front()
            .text;
    };
    EXPECT_NE(text("hemisphere", "calculix").find("NBASE, 1, 2\n"), std::string::npos);
    EXPECT_NE(text("ball_between_plates", "calculix").find("NBASE, 2, 2\n"), std::string::npos);
    EXPECT_NE(text("hemisphere", "freefem").find("on(2, u=0, w=0)"), std::string::npos);
    EXPECT_NE(text("cylinder_between_plates", "freefem").find("on(2, w=0)"), std::string::npos);
    EXPECT_NE(text("hemisphere", "getfem").find("simplification('u', BASE)"), std::string::npos);
    EXPECT_EQ(text("ball_between_plates", "getfem").find("simplification('u', BASE)"),
              std::string::npos);
}

// Two arcs that touch in the lowest point, at nodes of the same angles.
TEST(RoundDeck, PinTouchesTheHole) {
    const auto files =
        write_closed_deck({.code = "calculix", .levels = 1, .problem = "pin_in_hole"});
    std::stringstream lines(files.front().text);
    std::string line;
    int on_hole = 0, on_pin = 0, both = 0;
    while (std::getline(lines, line) && !line.starts_with("*NODE")) {
    }
    while (std::getline(lines, line) && !line.starts_with('*')) {
        int node = 0;
        double x = 0, y = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%d,%lf,%lf", &node, &x, &y), 3) << line;
        on_hole += std::abs(std::hypot(x, y) - 10) < 1e-8;
        on_pin += std::abs(std::hypot(x, y + .02) - 9.98) < 1e-8;
        both += std::hypot(x, y + 10) < 1e-8;
    }
    EXPECT_EQ(on_hole, on_pin);
    EXPECT_GT(on_hole, 20);
    EXPECT_EQ(both, 2);
}

// A ring without a slit: its area, and n(n + 1) + n(n) nodes of n elements around and m deep,
// middles with them. Friction begins with the second step, as the case has it.
TEST(RoundDeck, CylinderAroundItsHub) {
    Reference reference = reference_of("cattaneo_two_cylinders", .5e-3);
    const DeckModel model =
        make_deck_model(reference, {.code = "calculix", .problem = "cattaneo_two_cylinders"});
    for (const int level : {0, 1}) {
        const DeckMesh mesh = bodies_of(model, 4, level, true);
        const double ring = std::numbers::pi * (100 - 9);
        EXPECT_NEAR(volume_of(mesh, mesh.n_body_elements, mesh.n_elements()), ring, 1e-3 * ring);
        std::map<int, int> corners;
        for (int e = mesh.n_body_elements; e < mesh.n_elements(); ++e)
            for (int k = 0; k < 4; ++k) ++corners[mesh.elements[e][k]];
        // Two elements meet in a node of the surface or the hub, four in all others.
        for (const auto& [node, n] : corners) {
            const double r =
                std::hypot(mesh.nodes[node][0], mesh.nodes[node][1] - radius + model.overlap);
            EXPECT_EQ(n, is_near(r, radius) || is_near(r, 3) ? 2 : 4) << r;
        }
    }
    const auto text_of = [&](const char* code) {
        return write_deck(reference, {.code = code, .levels = 1, .problem = "p"}).front().text;
    };
    for (const char* code : {"calculix", "abaqus"}) {
        const std::string text = text_of(code);
        EXPECT_LT(text.find("*FRICTION"), text.find("** step 1"));
        EXPECT_GT(text.find("*CHANGE FRICTION, INTERACTION=CONTACT\n*FRICTION"),
                  text.find("** step 2"));
    }
    EXPECT_THROW(text_of("freefem"), contact::InputError);
    reference = reference_of("carter_two_cylinders", .5e-3);
    EXPECT_THROW(text_of("calculix"), contact::InputError);
}

TEST(RoundDeck, SaysWhatNoDeckHas) {
    const auto refusal = [](const contact::Case& c, const std::string& code) -> std::string {
        Reference reference = reference_of("hemisphere", 1.0246e-3);
        reference.c = c;
        try {
            write_deck(reference, {.code = code, .problem = "p"});
        } catch (const contact::InputError& error) {
            return error.what();
        }
        return "";
    };
    const contact::Case layer = required_problem("hemisphere_on_layer").make_case();
    EXPECT_EQ(refusal(layer, "mesh"), "");
    contact::Case rough = layer;
    rough.contact.coupling = true;
    for (const char* code : {"freefem", "getfem"})
        EXPECT_NE(refusal(rough, code).find("pressed once without friction"), std::string::npos)
            << code;
    EXPECT_EQ(refusal(rough, "calculix"), "");
    contact::Case c = required_problem("cylinder_between_plates").make_case();
    c.indenter.body->support = contact::ElasticBody::Support::hub;
    EXPECT_NE(refusal(c, "calculix").find("between equal plates"), std::string::npos);
    c = required_problem("hemisphere").make_case();
    c.contact.coupling = true;
    c.load.tangential_force = .1;
    EXPECT_NE(refusal(c, "calculix").find("without friction"), std::string::npos);
    // Half a ball as wide as two and a half contacts.
    Reference wide = reference_of("hemisphere", 4.1e-3);
    EXPECT_THROW(write_deck(wide, {.code = "calculix", .problem = "p"}), contact::InputError);
}

}  // namespace round_deck_test
}  // namespace tricontact::benchmarks

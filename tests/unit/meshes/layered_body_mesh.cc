#include "meshes/layered_body_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "contact/base/error.h"
#include "meshes/layer_mesh.h"
#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::layered_body_mesh_test {
namespace {

double volume_of(const HexMesh& mesh) {
    // Divergence theorem, faces outwards.
    double volume = 0;
    for (const auto& face : mesh.faces) {
        const auto& n = face.nodes;
        const Point normal = cross(difference(mesh.nodes[n[2]], mesh.nodes[n[0]]),
                                   difference(mesh.nodes[n[3]], mesh.nodes[n[1]]));
        volume += dot(centre_of(mesh, n), normal) / 6;
    }
    return volume;
}

HubBallMeshSpec ball(double patch, bool half) {
    return {.radius = 1e-2,
            .hub_radius = 3e-3,
            .size = patch / 5,
            .patch_x = patch,
            .patch_y = patch,
            .growth = 1.8,
            .half_model = half};
}

PunchMeshSpec punch(double patch, bool half) {
    return {.radius = 1e-2,
            .height = 6e-3,
            .size = patch / 5,
            .patch_x = patch,
            .patch_y = patch,
            .growth = 1.8,
            .half_model = half,
            .profile = [](double r) { return std::pow(std::max(0., r - 2e-3), 2) / 2e-2; }};
}

void expect_sound_and_matching(const HexMesh& mesh, double patch, bool half) {
    EXPECT_EQ(mesh.has_symmetry(), half);
    expect_sound(mesh);
    EXPECT_EQ(patch_nodes(mesh), patch_nodes(make_layer_mesh({.size = patch / 5,
                                                              .patch_x = patch,
                                                              .patch_y = patch,
                                                              .half_x = 5e-2,
                                                              .half_y = 5e-2,
                                                              .thickness = 5e-3,
                                                              .half_model = half,
                                                              .ends = {}})));
}

// Turned by an element about the axis along y through its middle, the patch of one that rolls falls
// on itself; its rows are as far along y as the layer's.
TEST(MeshesLayeredBody, BallThatRollsIsSoundAndHasAPatchOfRevolution) {
    HubBallMeshSpec s = ball(4e-3, true);
    s.patch_y = 1.6e-3;
    s.rolls = true;
    const HexMesh mesh = make_hub_ball_mesh(s);
    expect_sound(mesh);
    std::set<int> nodes;
    for (const auto& face : mesh.faces)
        if (face.boundary == Boundary::contact) nodes.insert(face.nodes.begin(), face.nodes.end());
    std::vector<Point> patch;
    for (const int node : nodes) patch.push_back(mesh.nodes[node]);
    const double angle = s.size / s.radius, edge = s.radius * std::sin(s.patch_x / s.radius);
    int n_turned = 0;
    for (const Point& p : patch) {
        const double up = p[2] + s.radius;
        if (std::atan2(p[0], up) > s.patch_x / s.radius - angle / 2) continue;
        const Point turned{std::cos(angle) * p[0] + std::sin(angle) * up, p[1],
                           std::cos(angle) * up - std::sin(angle) * p[0] - s.radius};
        const bool is_there = std::ranges::any_of(patch, [&](const Point& q) {
            return std::hypot(q[0] - turned[0], q[1] - turned[1], q[2] - turned[2]) < 1e-12;
        });
        EXPECT_TRUE(is_there) << p[0] << ' ' << p[1];
        ++n_turned;
        EXPECT_LE(std::abs(p[0]), edge);
        const double rows = p[1] / s.size;
        EXPECT_NEAR(rows, std::round(rows), 1e-9);
    }
    EXPECT_EQ(n_turned, 10 * 3);  // columns of nodes less one, times rows
}

TEST(MeshesLayeredBody, BallOnAHubIsSoundAndMatchesTheLayer) {
    for (const bool half : {false, true})
        for (const double patch : {2e-4, 2e-3, 5.3e-3}) {
            const HubBallMeshSpec s = ball(patch, half);
            const HexMesh mesh = make_hub_ball_mesh(s);
            expect_sound_and_matching(mesh, patch, half);
            const double exact = (half ? 2 : 4) * std::numbers::pi / 3 *
                                 (std::pow(s.radius, 3) - std::pow(s.hub_radius, 3));
            // Edges are straight, and elements grow to 30 degrees where nothing touches.
            EXPECT_NEAR(volume_of(mesh) / exact, 1, .03);
            for (const auto& face : mesh.faces) {
                if (face.boundary == Boundary::symmetry) continue;
                const double radius = face.boundary == Boundary::base ? s.hub_radius : s.radius;
                for (const int n : face.nodes)
                    EXPECT_NEAR(distance(mesh.nodes[n], {0, 0, -s.radius}) / radius, 1, 1e-13);
            }
        }
}

TEST(MeshesLayeredBody, PunchIsSoundAndMatchesTheLayer) {
    for (const bool half : {false, true})
        for (const double patch : {1e-3, 2.5e-3, 6e-3}) {
            const PunchMeshSpec s = punch(patch, half);
            const HexMesh mesh = make_punch_mesh(s);
            expect_sound_and_matching(mesh, patch, half);
            for (const auto& face : mesh.faces)
                for (const int n : face.nodes) {
                    const Point& p = mesh.nodes[n];
                    const double r = std::hypot(p[0], p[1]);
                    if (face.boundary == Boundary::base) {
                        EXPECT_EQ(p[2], -s.height);
                    } else if (face.boundary == Boundary::contact) {
                        EXPECT_NEAR(p[2], -s.profile(r), 1e-15);
                    }
                    EXPECT_LE(r, s.radius * (1 + 1e-14));
                }
        }
}

TEST(MeshesLayeredBody, WhatDoesNotFitIsRefused) {
    HubBallMeshSpec wide_hub = ball(1e-3, true);
    wide_hub.hub_radius = 1e-2;
    EXPECT_THROW(make_hub_ball_mesh(wide_hub), contact::InputError);
    EXPECT_THROW(make_hub_ball_mesh(ball(6e-3, true)), contact::InputError);
    EXPECT_THROW(make_punch_mesh(punch(7e-3, true)), contact::InputError);
    PunchMeshSpec flat = punch(1e-3, true);
    flat.height = 3e-3;  // the edge is 3.2 mm high
    EXPECT_THROW(make_punch_mesh(flat), contact::InputError);
}

}  // namespace
}  // namespace tricontact::meshes::layered_body_mesh_test

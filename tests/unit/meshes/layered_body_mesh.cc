#include "meshes/layered_body_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

TEST(MeshesLayeredBody, BallOnAHubIsSoundAndMatchesTheLayer) {
    for (const bool half : {false, true})
        for (const double patch : {2e-4, 2e-3, 5.3e-3}) {
            const HubBallMeshSpec s = ball(patch, half);
            const HexMesh mesh = make_hub_ball_mesh(s);
            expect_sound_and_matching(mesh, patch, half);
            const double exact = (half ? 2 : 4) * std::numbers::pi / 3 *
                                 (std::pow(s.radius, 3) - std::pow(s.hub_radius, 3));
            // Chords of at most 18 degrees: (18/57.3)^2/8 and less.
            EXPECT_NEAR(volume_of(mesh) / exact, 1, .02);
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

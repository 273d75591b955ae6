#include "meshes/round_body_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "meshes/layer_mesh.h"
#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::round_body_mesh_test {
namespace {

HalfBallMeshSpec ball(double patch, double size, bool half) {
    return {.radius = 1e-2,
            .size = size,
            .patch_x = patch,
            .patch_y = patch,
            .growth = 1.8,
            .half_model = half};
}

/// Area seen along z, positive where the outside is above.
double shadow(const HexMesh& mesh, Boundary boundary) {
    double sum = 0;
    for (const auto& face : mesh.faces) {
        if (face.boundary != boundary) continue;
        const auto& n = face.nodes;
        sum += cross(difference(mesh.nodes[n[2]], mesh.nodes[n[0]]),
                     difference(mesh.nodes[n[3]], mesh.nodes[n[1]]))[2] /
               2;
    }
    return sum;
}

LayerMeshSpec layer_below(double size, double patch, bool half) {
    return {.size = size,
            .patch_x = patch,
            .patch_y = patch,
            .half_x = 3e-2,
            .half_y = 3e-2,
            .thickness = 5e-3,
            .half_model = half,
            .ends = {}};
}

TEST(MeshesRoundBody, HalfBallIsSoundAndMatchesTheLayer) {
    for (const bool half : {false, true})
        for (const double patch : {1e-3, 3.5e-3, 5.3e-3}) {
            const HalfBallMeshSpec s = ball(patch, patch / 9, half);
            const HexMesh mesh = make_half_ball_mesh(s);
            EXPECT_EQ(mesh.has_symmetry(), half);
            expect_sound(mesh);
            EXPECT_EQ(patch_nodes(mesh),
                      patch_nodes(make_layer_mesh(layer_below(s.size, patch, half))));
            // What is above and below has the same shadow, and the base is the equator's disc.
            const double disc = (half ? .5 : 1) * std::numbers::pi * s.radius * s.radius;
            EXPECT_NEAR(shadow(mesh, Boundary::base) / -disc, 1, .01);
            EXPECT_NEAR((shadow(mesh, Boundary::contact) + shadow(mesh, Boundary::sides) +
                         shadow(mesh, Boundary::base)) /
                            disc,
                        0, 1e-12);
            for (const auto& face : mesh.faces) {
                if (face.boundary != Boundary::contact && face.boundary != Boundary::sides)
                    continue;
                for (const int n : face.nodes)
                    EXPECT_NEAR(distance(mesh.nodes[n], {0, 0, -s.radius}) / s.radius, 1, 1e-14);
            }
        }
}

// Nodes of the patch of a cylinder that rolls are as far apart along its surface.
TEST(MeshesRoundBody, CylinderThatRollsHasEqualElementsAlongItsSurface) {
    CylinderMeshSpec s{.radius = 1e-2,
                       .size = 1e-3,
                       .patch_x = 2.5e-2,
                       .half_y = 2e-3,
                       .growth = 1.8,
                       .hub_radius = 3e-3,
                       .rolls = true};
    const HexMesh mesh = make_cylinder_mesh(s);
    expect_sound(mesh);
    std::set<int> nodes;
    for (const auto& face : mesh.faces)
        if (face.boundary == Boundary::contact) nodes.insert(face.nodes.begin(), face.nodes.end());
    std::vector<double> along;
    for (const int n : nodes)
        if (mesh.nodes[n][1] == 0)
            along.push_back(s.radius * std::atan2(mesh.nodes[n][0], mesh.nodes[n][2] + s.radius));
    std::ranges::sort(along);
    ASSERT_EQ(along.size(), 51u);
    for (int i = 0; i < 51; ++i) EXPECT_NEAR(along[i], (i - 25) * s.size, 1e-15) << i;
    s.patch_x = 2.8e-2;
    EXPECT_THROW(make_cylinder_mesh(s), contact::InputError);
}

TEST(MeshesRoundBody, CylinderIsSoundAndMatchesTheLayer) {
    for (const double hub : {0., 3e-3})
        for (const double patch : {1e-3, 3.5e-3, 7.5e-3}) {
            const CylinderMeshSpec s{.radius = 1e-2,
                                     .size = patch / 5,
                                     .patch_x = patch,
                                     .half_y = 2e-3,
                                     .growth = 1.8,
                                     .hub_radius = hub};
            const HexMesh mesh = make_cylinder_mesh(s);
            expect_sound(mesh);
            LayerMeshSpec layer = layer_below(s.size, patch, true);
            layer.plane_strain = true;
            layer.patch_y = layer.half_y = s.half_y;
            EXPECT_EQ(patch_nodes(mesh), patch_nodes(make_layer_mesh(layer)));
            double volume = 0;
            for (const auto& hex : mesh.hexes) {
                const auto corners = corners_of(mesh, hex);  // prisms along y
                volume += std::abs(cross(difference(corners[5], corners[0]),
                                         difference(corners[4], corners[1]))[1]) /
                          2 * s.half_y;
            }
            const double section = std::numbers::pi * (hub > 0 ? s.radius * s.radius - hub * hub
                                                               : s.radius * s.radius / 2);
            // Chords for arcs.
            EXPECT_NEAR(volume / (section * s.half_y), 1, .02) << hub << " " << patch;
            for (const auto& face : mesh.faces) {
                const bool outside =
                    face.boundary == Boundary::contact || face.boundary == Boundary::sides;
                if (!outside && !(face.boundary == Boundary::base && hub > 0)) continue;
                const double radius = outside ? s.radius : hub;
                for (const int n : face.nodes)
                    EXPECT_NEAR(std::hypot(mesh.nodes[n][0], mesh.nodes[n][2] + s.radius) / radius,
                                1, 1e-12);
            }
        }
}

TEST(MeshesRoundBody, RefusesAPatchThatIsTooWide) {
    EXPECT_EQ(message_of([] { make_half_ball_mesh(ball(7e-3, 1e-3, true)); }),
              "mesh of the indenter: the contact patch reaches 0.009899 m from the middle, too far "
              "for the radius 0.01 m: more than 49 degrees; reduce the load or enlarge the radius");
}

TEST(MeshesRoundBody, RefusesAHubThatIsTooThick) {
    expect_refusal(message_of([] {
                       make_cylinder_mesh({.radius = 1e-2,
                                           .size = 1e-3,
                                           .patch_x = 1e-3,
                                           .half_y = 1e-3,
                                           .growth = 1.8,
                                           .hub_radius = 1e-2});
                   }),
                   "mesh of the indenter", "a hub of the radius 0.01 m");
}

}  // namespace
}  // namespace tricontact::meshes::round_body_mesh_test

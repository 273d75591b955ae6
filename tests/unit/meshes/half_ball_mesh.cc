#include "meshes/half_ball_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "meshes/layer_mesh.h"
#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::half_ball_mesh_test {
namespace {

HalfBallMeshSpec ball(double patch, double size, bool half) {
    return {.radius = 1e-2,
            .size = size,
            .patch_x = patch,
            .patch_y = patch,
            .growth = 1.8,
            .half_model = half};
}

std::set<std::array<double, 2>> patch_nodes(const HexMesh& mesh) {
    std::set<std::array<double, 2>> nodes;
    for (const auto& face : mesh.faces)
        if (face.boundary == Boundary::contact)
            for (const int n : face.nodes) nodes.insert({mesh.nodes[n][0], mesh.nodes[n][1]});
    return nodes;
}

double area_along_z(const HexMesh& mesh, Boundary boundary) {
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

TEST(MeshesHalfBall, IsSoundAndMatchesTheLayer) {
    for (const bool half : {false, true})
        for (const double patch : {1e-3, 3.5e-3}) {
            const HalfBallMeshSpec s = ball(patch, patch / 5, half);
            const HexMesh mesh = make_half_ball_mesh(s);
            EXPECT_EQ(mesh.has_symmetry(), half);
            // Every face of one hexahedron only is named, once, from outside.
            const FaceTable table(mesh);
            std::size_t n_outside = 0;
            for (std::size_t f = 0; f < table.n_faces(); ++f) {
                ASSERT_LE(table.sides(f).size(), 2);
                n_outside += table.sides(f).size() == 1;
            }
            EXPECT_EQ(mesh.faces.size(), n_outside);
            for (const auto& face : mesh.faces) {
                const std::size_t at = table.find(face.nodes);
                ASSERT_LT(at, table.n_faces());
                EXPECT_EQ(table.sides(at).size(), 1);
            }
            for (const auto& hex : mesh.hexes) EXPECT_GT(least_jacobian(corners_of(mesh, hex)), 0);
            const LayerMeshSpec layer{.size = s.size,
                                      .patch_x = patch,
                                      .patch_y = patch,
                                      .half_x = 3e-2,
                                      .half_y = 3e-2,
                                      .thickness = 5e-3,
                                      .half_model = half,
                                      .ends = {}};
            EXPECT_EQ(patch_nodes(mesh), patch_nodes(make_layer_mesh(layer)));
            // Both sides of the body cast the same shadow, the base's is the equator's disc.
            const double disc = (half ? .5 : 1) * std::numbers::pi * s.radius * s.radius;
            EXPECT_NEAR(area_along_z(mesh, Boundary::base) / -disc, 1, .01);
            EXPECT_NEAR((area_along_z(mesh, Boundary::contact) +
                         area_along_z(mesh, Boundary::sides) + area_along_z(mesh, Boundary::base)) /
                            disc,
                        0, 1e-12);
            // Corners of contact and sides on the sphere.
            for (const auto& face : mesh.faces)
                if (face.boundary == Boundary::contact || face.boundary == Boundary::sides)
                    for (const int n : face.nodes)
                        EXPECT_NEAR(distance(mesh.nodes[n], {0, 0, -s.radius}) / s.radius, 1,
                                    1e-14);
        }
}

TEST(MeshesHalfBall, RefusesAPatchThatIsTooWide) {
    EXPECT_EQ(message_of([] { make_half_ball_mesh(ball(6e-3, 1e-3, true)); }),
              "half ball mesh: the contact patch of 0.012 m x 0.012 m is too wide for a ball of "
              "the radius 0.01 m: its corners are more than 45 degrees from the pole; reduce the "
              "load or enlarge the radius");
}

}  // namespace
}  // namespace tricontact::meshes::half_ball_mesh_test

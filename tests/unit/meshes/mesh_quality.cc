#include <gtest/gtest.h>

#include <cmath>

#include "meshes/hex_mesh.h"
#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::mesh_quality_test {
namespace {

// One box a x b x c with its top in z = 0, its upper face the contact.
HexMesh box(double a, double b, double c) {
    HexMesh mesh;
    mesh.nodes = {{0, 0, -c}, {a, 0, -c}, {a, b, -c}, {0, b, -c},
                  {0, 0, 0},  {a, 0, 0},  {a, b, 0},  {0, b, 0}};
    mesh.hexes = {{0, 1, 2, 3, 4, 5, 6, 7}};
    mesh.regions = {Region::layer};
    mesh.faces = {{{4, 5, 6, 7}, Boundary::contact}, {{0, 3, 2, 1}, Boundary::base}};
    return mesh;
}

TEST(MeshesQuality, OfABox) {
    const MeshQuality q = quality(box(0.3, 0.5, 1.2));
    EXPECT_EQ(q.n_nodes, 8U);
    EXPECT_EQ(q.n_hexes, 1U);
    EXPECT_EQ(q.n_contact_faces, 1U);
    EXPECT_NEAR(q.least_jacobian, 1, 1e-15);
    EXPECT_NEAR(q.largest_aspect_ratio, 4, 1e-14);
    EXPECT_EQ(q.contact_size, 0.5);
    EXPECT_EQ(q.low, (std::array<double, 3>{0, 0, -1.2}));
    EXPECT_EQ(q.high, (std::array<double, 3>{0.3, 0.5, 0}));
}

// A shear by the angle s turns the upright edges: volume unchanged, edges longer by 1/cos s.
TEST(MeshesQuality, OfAShearedBox) {
    for (const double angle : {0.1, 0.7, 1.3}) {
        HexMesh mesh = box(0.3, 0.5, 0.3);
        for (int i = 4; i < 8; ++i) mesh.nodes[i][0] += 0.3 * std::tan(angle);
        const MeshQuality q = quality(mesh);
        EXPECT_NEAR(q.least_jacobian, std::cos(angle), 1e-14) << angle;
        EXPECT_NEAR(q.largest_aspect_ratio, std::max(0.5, 0.3 / std::cos(angle)) / 0.3, 1e-14);
        EXPECT_NEAR(least_jacobian(corners_of(mesh, mesh.hexes[0])), 0.3 * 0.5 * 0.3, 1e-15);
    }
}

// A cube of edge 1 with one corner moved inwards along the diagonal by t in each coordinate: there
// the edge vectors keep length sqrt((1-t)^2 + 2 t^2), and their determinant is that of
// (1-t) I - t (offdiagonal) = (1 - 3t) (1)^2 with eigenvalues 1-3t, 1, 1.
TEST(MeshesQuality, OfADentedCube) {
    for (const double t : {0.1, 0.25, 0.4}) {
        HexMesh mesh = box(1, 1, 1);
        for (double& x : mesh.nodes[6]) x -= t;
        const double edge = std::sqrt((1 - t) * (1 - t) + 2 * t * t);
        EXPECT_NEAR(quality(mesh).least_jacobian, (1 - 3 * t) / std::pow(edge, 3), 1e-14) << t;
        EXPECT_NEAR(least_jacobian(corners_of(mesh, mesh.hexes[0])), 1 - 3 * t, 1e-14) << t;
    }
}

// Found by a search: positive at all corners (at least 1/4), -21/32 at its least mid-point, as
// exact arithmetic gives from the trilinear map.
TEST(MeshesQuality, TheJacobianIsLookedAtInsideToo) {
    const std::array<Point, 8> corners{{{0, 0, 0},
                                        {-1, 0.25, -1.5},
                                        {1, 1, 0},
                                        {0, 1, 0},
                                        {1.5, -2, 1.75},
                                        {1, 0, 1},
                                        {1, 1, 1},
                                        {0, 1, 1}}};
    HexMesh mesh = box(1, 1, 1);
    mesh.nodes.assign(corners.begin(), corners.end());
    EXPECT_GT(quality(mesh).least_jacobian, 0);
    EXPECT_DOUBLE_EQ(least_jacobian(corners), -21. / 32);
}

TEST(MeshesQuality, TakesTheWorstElement) {
    const LayerMeshSpec s = small_spec();
    HexMesh mesh = make_layer_mesh(s);
    const MeshQuality good = quality(mesh);
    EXPECT_EQ(good.n_nodes, mesh.nodes.size());
    EXPECT_EQ(good.n_hexes, mesh.hexes.size());
    EXPECT_EQ(good.n_contact_faces, 24U);
    EXPECT_NEAR(good.least_jacobian, 1, 1e-12);
    EXPECT_NEAR(good.contact_size / s.size, 1, 1e-12);
    mesh.nodes.back()[2] += s.size / 3;
    EXPECT_LT(quality(mesh).least_jacobian, 0.999);
}

TEST(MeshesQuality, OfNothingIsZero) {
    const MeshQuality q = quality({});
    EXPECT_EQ(q.n_hexes, 0U);
    EXPECT_EQ(q.least_jacobian, 0);
    EXPECT_EQ(q.contact_size, 0);
}

}  // namespace
}  // namespace tricontact::meshes::mesh_quality_test

#include "fem/brick_elements.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/q2_space.h"
#include "meshes/layer_mesh.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::brick_elements_test {
namespace {

using fem::Q2Space;

meshes::HexMesh two_layers() {
    return test::box_mesh({test::mirrored(test::graded(.25, .5, 3, 1.7)),
                           test::graded(.25, .5, 2, 1.7), test::even(-2, 0, 3), .5, .5, true, -1});
}

meshes::HexMesh rig_layer() {
    return meshes::make_layer_mesh({.size = .5e-3,
                                    .patch_x = 2e-3,
                                    .patch_y = 1e-3,
                                    .half_x = 20e-3,
                                    .half_y = 20e-3,
                                    .thickness = 8e-3,
                                    .half_model = true});
}

void expect_same_integration(const Q2Space& own, const Q2Space& other, int n_points) {
    constexpr double rounding = 1e-13;
    fem::ElementValues values(own, n_points), expected(other, n_points);
    for (std::size_t c = 0; c < own.cells.size(); ++c) {
        values.reinit(c);
        expected.reinit(c);
        for (std::size_t q = 0; q < values.weights.size(); ++q) {
            ASSERT_NEAR(values.weights[q] / expected.weights[q], 1, rounding);
            for (int d = 0; d < 3; ++d) {
                double largest = 0;
                for (const auto& gradient : expected.gradients[q])
                    largest = std::max(largest, std::abs(gradient[d]));
                ASSERT_NEAR(values.points[q][d] * largest, expected.points[q][d] * largest,
                            100 * rounding);
                for (int i = 0; i < 27; ++i)
                    ASSERT_NEAR(values.gradients[q][i][d] / largest,
                                expected.gradients[q][i][d] / largest, rounding);
            }
        }
    }
}

TEST(FemBrickElements, NumbersAndIntegralsAreThoseOfDealII) {
    for (const meshes::HexMesh& mesh : {two_layers(), rig_layer()}) {
        const Q2Space own(mesh, fem::Elements::bricks_if_all_are), other(mesh);
        EXPECT_EQ(own.cells, other.cells);
        EXPECT_EQ(own.regions, other.regions);
        ASSERT_EQ(own.nodes.size(), other.nodes.size());
        for (std::size_t i = 0; i < own.nodes.size(); ++i)
            for (int d = 0; d < 3; ++d)
                ASSERT_NEAR(own.nodes[i][d], other.nodes[i][d], 1e-15 * std::abs(own.nodes[i][d]))
                    << i;
        ASSERT_EQ(own.faces.size(), other.faces.size());
        for (std::size_t f = 0; f < own.faces.size(); ++f) {
            ASSERT_EQ(own.faces[f].nodes, other.faces[f].nodes);
            ASSERT_EQ(own.faces[f].boundary, other.faces[f].boundary);
            const auto mass = own.face_mass(f), expected = other.face_mass(f);
            for (int i = 0; i < 9; ++i)
                for (int j = 0; j < 9; ++j)  // the largest: of the centre
                    ASSERT_NEAR(mass[i][j] / expected[8][8], expected[i][j] / expected[8][8],
                                1e-13);
        }
        expect_same_integration(own, other, 2);
        expect_same_integration(own, other, 3);
    }
}

TEST(FemBrickElements, OnlyBricksWithNamedBoundaries) {
    const meshes::HexMesh mesh = two_layers();
    Q2Space space(mesh);
    const std::size_t n = space.nodes.size();
    meshes::HexMesh moved = mesh, unnamed = mesh, turned = mesh, inside = mesh;
    moved.nodes.front()[2] *= 1 + 1e-15;
    unnamed.faces.pop_back();
    auto& hex = turned.hexes.front();
    hex = {hex[1], hex[2], hex[3], hex[0], hex[5], hex[6], hex[7], hex[4]};
    const auto& own = mesh.hexes.front();
    for (const auto& face : meshes::hex_faces)
        inside.faces.push_back(
            {{own[face[0]], own[face[1]], own[face[2]], own[face[3]]}, meshes::Boundary::base});
    for (const auto& other : {moved, unnamed, turned, inside})
        EXPECT_EQ(fem::brick_elements(other, space), nullptr);
    EXPECT_EQ(space.nodes.size(), n);
}

}  // namespace
}  // namespace tricontact::brick_elements_test

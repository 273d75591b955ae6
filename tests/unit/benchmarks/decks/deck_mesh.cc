// Lines and meshes of decks: nested, similar, of the block's volume, no element turned inside out.

#include "benchmarks/decks/deck_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "benchmarks/decks/graded_line.h"

namespace tricontact::benchmarks::deck_mesh_test {
namespace {

TEST(GradedLine, EndsWhereItShouldAndGrowsByOneFactor) {
    const std::vector<double> line = graded_line(0, 1.5, 4, 48, 1.6);
    EXPECT_EQ(line.back(), 48);
    EXPECT_DOUBLE_EQ(line[4], 6);
    const double factor = (line[6] - line[5]) / (line[5] - line[4]);
    EXPECT_LE(factor, 1.6);
    for (std::size_t i = 6; i < line.size(); ++i)
        EXPECT_NEAR((line[i] - line[i - 1]) / (line[i - 1] - line[i - 2]), factor, 1e-9);
}

TEST(GradedLine, NothingBeyondTheEqualElements) {
    EXPECT_EQ(graded_line(0, 2, 3, 6, 1.6), (std::vector<double>{0, 2, 4, 6}));
}

TEST(GradedLine, NodesOfACoarseLineAreNodesOfAFineOne) {
    const std::vector<double> coarse = graded_line(0, 1.1, 3, 20, 1.7),
                              fine = refined_line(coarse, 3);
    ASSERT_EQ(fine.size() - 1, 8 * (coarse.size() - 1));
    for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_EQ(fine[8 * i], coarse[i]);
}

TEST(GradedLine, Mirrored) {
    EXPECT_EQ(mirrored_line({0, 1, 3}), (std::vector<double>{-3, -1, 0, 1, 3}));
}

DeckMesh block(bool is_quadratic, const BlockLines& lines,
               const std::function<DeckMesh::Point(DeckMesh::Point)>& place) {
    DeckMesh mesh;
    mesh.is_quadratic = is_quadratic;
    mesh.dimension = lines.is_spatial() ? 3 : 2;
    add_block(mesh, lines, place, {{"LOW", [](const auto& p) { return p[1] == 0; }}});
    return mesh;
}

DeckMesh::Point unmoved(DeckMesh::Point p) {
    return p;
}

TEST(DeckMesh, CountsOfNodes) {
    const BlockLines plane{{0, 1, 2, 4}, {0, 1, 3}, {}}, box{{0, 1, 2}, {0, 1}, {0, 2}};
    EXPECT_EQ(block(false, plane, unmoved).nodes.size(), 12u);
    // Corners and middles of the 17 edges.
    EXPECT_EQ(block(true, plane, unmoved).nodes.size(), 12u + 17u);
    EXPECT_EQ(block(false, box, unmoved).nodes.size(), 12u);
    EXPECT_EQ(block(true, box, unmoved).nodes.size(), 12u + 20u);
    EXPECT_EQ(block(true, plane, unmoved).node_sets.at("LOW").size(), 7u);
}

TEST(DeckMesh, VolumeIsThatOfTheBlock) {
    const BlockLines plane{{0, 1, 2, 4}, {0, 1, 3}, {}}, box{{0, 1, 2}, {0, 1}, {0, 2}};
    for (const bool is_quadratic : {false, true}) {
        const DeckMesh flat = block(is_quadratic, plane, unmoved);
        EXPECT_NEAR(volume_of(flat, 0, flat.n_elements()), 12, 1e-12);
        const DeckMesh solid = block(is_quadratic, box, unmoved);
        EXPECT_NEAR(volume_of(solid, 0, solid.n_elements()), 4, 1e-12);
    }
}

// Under y = x^2/10 + (1 - x^2/10) y of elements whose middles lie on the curve: 4 - 8/30.
TEST(DeckMesh, QuadraticElementsFollowAParabola) {
    const DeckMesh curved = block(true, {{0, 1, 2}, {0, 2}, {}}, [](DeckMesh::Point p) {
        p[1] += p[0] * p[0] / 10 * (1 - p[1] / 2);
        return p;
    });
    EXPECT_NEAR(volume_of(curved, 0, curved.n_elements()), 4 - 8. / 30, 1e-12);
}

TEST(DeckMesh, ElementsTurnedInsideOutAreNoticed) {
    const DeckMesh mirrored = block(false, {{0, 1}, {0, 1}, {}}, [](DeckMesh::Point p) {
        p[0] = -p[0];
        return p;
    });
    EXPECT_THROW(volume_of(mirrored, 0, 1), std::logic_error);
}

// Outward normals of a brick's faces, from their corners in order, sum to zero and face outwards.
TEST(DeckMesh, FacesOfABrickLookOutwards) {
    const DeckMesh brick = block(true, {{0, 1}, {0, 1}, {0, 1}}, unmoved);
    for (int face = 1; face <= 6; ++face) {
        const std::vector<int> nodes = brick.face_nodes({0, face});
        ASSERT_EQ(nodes.size(), 8u);
        const auto& a = brick.nodes[nodes[0]];
        const auto& b = brick.nodes[nodes[1]];
        const auto& c = brick.nodes[nodes[2]];
        double outwards = 0;
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            const double normal = (b[i] - a[i]) * (c[j] - b[j]) - (b[j] - a[j]) * (c[i] - b[i]);
            outwards += normal * (a[k] + c[k] - 1) / 2;
        }
        EXPECT_NEAR(std::abs(outwards), .5, 1e-12) << face;
        // A middle lies between its corners.
        for (int k = 0; k < 4; ++k)
            for (int x = 0; x < 3; ++x)
                EXPECT_DOUBLE_EQ(
                    brick.nodes[nodes[4 + k]][x],
                    (brick.nodes[nodes[k]][x] + brick.nodes[nodes[(k + 1) % 4]][x]) / 2);
    }
}

}  // namespace
}  // namespace tricontact::benchmarks::deck_mesh_test

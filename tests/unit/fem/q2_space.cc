#include "fem/q2_space.h"

#include <gtest/gtest.h>
#include <vtkBiQuadraticQuad.h>
#include <vtkNew.h>
#include <vtkTriQuadraticHexahedron.h>

#include <Eigen/Dense>
#include <numeric>
#include <set>

#include "contact/base/error.h"
#include "tests/unit/fem/box_mesh.h"

namespace tricontact::q2_space_test {
namespace {

using Eigen::Vector3d;
using fem::Q2Space;
using meshes::Boundary;

Vector3d at(const Q2Space& space, int node) {
    return Vector3d(space.nodes[node].data());
}

meshes::HexMesh distorted_box() {
    auto mesh = test::box_mesh(
        {test::even(-1, 1, 4), test::even(-1, 1, 2), test::even(-3, 0, 3), .6, .6, false, -1.5});
    test::distort(mesh, .2);
    return mesh;
}

TEST(FemQ2Space, NodesAreInVtksOrder) {
    vtkNew<vtkTriQuadraticHexahedron> hexahedron;
    const double* parametric = hexahedron->GetParametricCoords();
    for (int i = 0; i < 27; ++i)
        for (int d = 0; d < 3; ++d)
            EXPECT_EQ(fem::node_positions[i][d], 2 * parametric[3 * i + d]) << i;

    const Q2Space space(distorted_box());
    for (const auto& cell : space.cells)
        for (int i = 0; i < 27; ++i) {
            Vector3d x = Vector3d::Zero();  // trilinear between the corners
            for (int v = 0; v < 8; ++v) {
                double weight = 1;
                for (int d = 0; d < 3; ++d)
                    weight *=
                        1 - std::abs(fem::node_positions[i][d] - fem::node_positions[v][d]) / 2.;
                x += weight * at(space, cell[v]);
            }
            ASSERT_LT((x - at(space, cell[i])).norm(), 1e-14) << i;  // rounding
        }
}

TEST(FemQ2Space, CellsAreThoseOfTheMesh) {
    const auto mesh = distorted_box();
    const Q2Space space(mesh);
    EXPECT_EQ(space.nodes.size(), 9u * 5 * 7);  // 4 x 2 x 3 hexahedra
    using Corners = std::set<std::array<double, 3>>;
    std::set<std::pair<Corners, meshes::Region>> expected, found;
    for (std::size_t c = 0; c < mesh.hexes.size(); ++c) {
        Corners corners;
        for (const int node : mesh.hexes[c]) corners.insert(mesh.nodes[node]);
        expected.emplace(corners, mesh.regions[c]);
    }
    for (std::size_t c = 0; c < space.cells.size(); ++c) {
        Corners corners;
        for (int v = 0; v < 8; ++v) corners.insert(space.nodes[space.cells[c][v]]);
        found.emplace(corners, space.regions[c]);
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(found.size(), 24u);
    double volume = 0;
    fem::ElementValues values(space, 3);
    for (std::size_t c = 0; c < space.cells.size(); ++c) {
        values.reinit(c);
        volume = std::accumulate(values.weights.begin(), values.weights.end(), volume);
    }
    EXPECT_NEAR(volume, 2 * 2 * 3, 1e-13);
}

TEST(FemQ2Space, FacesLookOutwardsWithTheirNames) {
    vtkNew<vtkBiQuadraticQuad> quad;
    const double* parametric = quad->GetParametricCoords();
    const auto mesh = distorted_box();
    const Q2Space space(mesh);
    EXPECT_EQ(space.faces.size(), mesh.faces.size());
    std::array<double, meshes::n_boundaries> area{};
    for (std::size_t f = 0; f < space.faces.size(); ++f) {
        const auto& [nodes, boundary] = space.faces[f];
        const Vector3d origin = at(space, nodes[0]), centre = at(space, nodes[8]);
        const Vector3d normal =
            (at(space, nodes[2]) - origin).cross(at(space, nodes[3]) - at(space, nodes[1]));
        EXPECT_GT(normal.dot(centre - Vector3d(0, 0, -1.5)), 0);  // the box is convex
        for (int i = 0; i < 9; ++i) {
            const double u = parametric[3 * i], v = parametric[3 * i + 1];
            const Vector3d x = (1 - v) * ((1 - u) * origin + u * at(space, nodes[1])) +
                               v * ((1 - u) * at(space, nodes[3]) + u * at(space, nodes[2]));
            EXPECT_LT((x - at(space, nodes[i])).norm(), 1e-14);
        }
        for (const auto& row : space.face_mass(f))
            for (const double m : row) area[static_cast<int>(boundary)] += m;
        if (boundary == Boundary::contact || boundary == Boundary::free_top) {
            EXPECT_EQ(centre[2], 0);
        }
        if (boundary == Boundary::base) {
            EXPECT_EQ(centre[2], -3);
        }
    }
    EXPECT_NEAR(area[static_cast<int>(Boundary::base)], 4, 1e-13);
    EXPECT_NEAR(area[static_cast<int>(Boundary::sides)], 4 * 2 * 3, 1e-13);
    EXPECT_NEAR(
        area[static_cast<int>(Boundary::contact)] + area[static_cast<int>(Boundary::free_top)], 4,
        1e-13);
}

TEST(FemQ2Space, AFaceWithoutANameIsRefused) {
    auto mesh = distorted_box();
    mesh.faces.erase(mesh.faces.begin() + 7);
    try {
        const Q2Space space(mesh);
        FAIL() << "accepted";
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("has no name"), std::string::npos);
    }
}

}  // namespace
}  // namespace tricontact::q2_space_test

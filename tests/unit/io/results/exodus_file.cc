// Meshes and fields of Exodus II, read back with VTK's own reader.

#include "io/results/exodus_file.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>

#include "contact/bodies/indenter.h"
#include "io/results/vtk_indenter.h"
#include "tests/unit/io/results/read_states.h"

namespace tricontact::io::exodus_file_test {
namespace {

using Exodus = ReadStates;

/// As VTK places them: points of the element's edges are between its corners, and so on.
TEST_F(Exodus, TwentySevenNodesHaveTheOrderOfExodus) {
    contact::Interior inside;
    // VTK's order of a triquadratic hexahedron, vtkTriQuadraticHexahedron.h.
    inside.points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                     {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
                     {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {0, 1, 1},
                     {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2}, {1, 1, 1}};
    inside.hexes.push_back({});
    for (int i = 0; i < 27; ++i) inside.hexes[0].at(static_cast<std::size_t>(i)) = i;
    inside.region = {0};
    inside.energy_density = {3.5};
    for (int i = 0; i < 27; ++i) {
        inside.displacement.push_back({1. + i, 2. + i, 3. + i});
        inside.stress.push_back({1., 2., 3., 4., 5., 6. + i});
    }
    StateSeries out = states("volume");
    out.add(0, inside);
    vtkUnstructuredGrid* grid = read("volume.ex2", 0);
    ASSERT_EQ(grid->GetCellType(0), 29) << "no triquadratic hexahedron";
    vtkIdType n = 0;
    const vtkIdType* points = nullptr;
    grid->GetCellPoints(0, n, points);
    ASSERT_EQ(n, 27);
    for (vtkIdType i = 0; i < n; ++i)
        for (int d = 0; d < 3; ++d)
            EXPECT_EQ(grid->GetPoint(points[i])[d],
                      inside.points[static_cast<std::size_t>(i)].at(static_cast<std::size_t>(d)))
                << "node " << i;
}

/// Uniaxial tension: von Mises' stress is the tension, the pressure -1/3 of it. Pure shear: sqrt 3
/// times the shear. Hydrostatic: none. Each in all directions.
TEST_F(Exodus, StressMeasuresAreThoseOfKnownStates) {
    contact::Interior inside;
    inside.axes = {std::vector<double>{-1. / 3, 1. / 7}, {0, 1e-3}, {-1. / 9, 0}};
    inside.displacement.resize(8);
    inside.stress.resize(8);
    for (std::size_t c = 0; c < 3; ++c) inside.stress[c].at(c) = 2e6;
    for (std::size_t c = 3; c < 6; ++c) inside.stress[c].at(c) = -1e6;
    inside.stress[6] = {-3e6, -3e6, -3e6, 0, 0, 0};
    StateSeries out = states("volume");
    out.add(0, inside);
    vtkUnstructuredGrid* grid = read("volume.ex2", 0);
    ASSERT_EQ(grid->GetNumberOfPoints(), 8);
    ASSERT_EQ(grid->GetCellType(0), 12) << "no hexahedron";
    for (int i = 0; i < 8; ++i)
        for (std::size_t d = 0; d < 3; ++d)
            EXPECT_EQ(grid->GetPoint(i)[d], inside.position(static_cast<std::size_t>(i)).at(d));
    vtkDataArray* mises = grid->GetPointData()->GetArray("von_mises_Pa");
    vtkDataArray* pressure = grid->GetPointData()->GetArray("pressure_Pa");
    ASSERT_TRUE(mises && pressure);
    for (int i = 0; i < 3; ++i) {
        EXPECT_FLOAT_EQ(mises->GetTuple1(i), 2e6);
        EXPECT_FLOAT_EQ(pressure->GetTuple1(i), -2e6 / 3);
        EXPECT_FLOAT_EQ(mises->GetTuple1(3 + i), std::sqrt(3) * 1e6);
        EXPECT_EQ(pressure->GetTuple1(3 + i), 0);
    }
    EXPECT_EQ(mises->GetTuple1(6), 0);
    EXPECT_FLOAT_EQ(pressure->GetTuple1(6), 3e6);
}

/// Values of elements go to the blocks one after another, also where they begin with bytes.
TEST_F(Exodus, BlocksHaveTheirOwnElements) {
    ExodusMesh mesh;
    for (int i = 0; i < 5; ++i) mesh.points.push_back({1. * i, 0.5 * (i % 2), 0});
    mesh.blocks = {
        {.name = "tips", .element = "SPHERE", .nodes_per_element = 1, .nodes = {2, 5, 1}},
        {.name = "spring", .element = "BAR2", .nodes_per_element = 2, .nodes = {1, 4}}};
    const auto fields = [](const std::vector<double>& values) {
        ExodusFields made;
        made.add_scalar("height", std::vector<double>(5, 1. / 3), 5);
        made.begin_elements();
        made.add_scalar("force", values, 4);
        return made;
    };
    StateSeries out = states("parts");
    out.add(0, mesh, fields({0, 0, 0, 0}));  // bytes
    out.add(1, mesh, fields({1.5, 2.5, 3.5, 4.5}));
    read("parts.ex2", 1);
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader_->GetOutput()->GetBlock(0));
    ASSERT_EQ(blocks->GetNumberOfBlocks(), 2u);
    const auto forces = [&](unsigned block) {
        auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(block));
        std::vector<double> found;
        for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
            found.push_back(grid->GetCellData()->GetArray("force")->GetTuple1(i));
        return found;
    };
    EXPECT_EQ(forces(0), (std::vector{1.5, 2.5, 3.5}));
    EXPECT_EQ(forces(1), std::vector{4.5});
    auto* spring = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(1u));
    EXPECT_EQ(spring->GetCell(0)->GetPointId(1), 3);
    EXPECT_EQ(vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(0u))->GetCellType(0), 1);
}

TEST_F(Exodus, TheIndenterMovesByItsDisplacement) {
    const IndenterShape shape(contact::Paraboloid(0.04), {.radius = 0.005});
    IndenterSeries out(folder_.string(), provenance_);
    out.add(0, shape, {.offset = {0.001, 0}, .indentation = 1e-4});
    out.add(1, shape, {.offset = {-0.001, 0.002}, .indentation = 2e-4, .rotation = 0.5});
    const double* lowest = read("indenter.ex2", 1, true)->GetPoint(0);
    EXPECT_NEAR(lowest[0], -0.001, 1e-9);  // single precision
    EXPECT_NEAR(lowest[1], 0.002, 1e-9);
    EXPECT_NEAR(lowest[2], -2e-4, 1e-10);
}

}  // namespace
}  // namespace tricontact::io::exodus_file_test

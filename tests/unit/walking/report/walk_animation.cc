#include "walking/report/walk_animation.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <set>

#include "tests/unit/io/results/read_states.h"
#include "tests/unit/walking/sets.h"
#include "walking/machine/motion.h"

namespace tricontact::walking::walk_animation_test {
namespace {

// A turned, lifted body: the left spot pressed, the right one in the air.
Snapshot some_snapshot(double time) {
    Motion motion{.time = time, .base = 3e-4, .x = 1e-4, .z = -2e-5, .phi = 4e-5};
    motion.spots = {{.normal = 6e-5, .tangential = 1e-5}, {}};
    return {motion, {SpotState::stick, SpotState::released}};
}

WalkCase dimensional_case() {
    WalkCase c;
    c.machine.kappas = walking::set_b();
    c.dimensional = with_dimensions(c.machine.kappas, 0.49, 14e-3);
    return c;
}

enum WalkPart : unsigned { spots, spring, body, ground, ground_marked };

class WalkAnimation : public io::ReadStates {
  protected:
    /// Blocks of the file: spots, spring, body, ground, ground_marked; of all points, not moved.
    vtkUnstructuredGrid* read(WalkPart part, double time, bool moved = false, double by = 1) {
        auto* blocks = blocks_of("machine.ex2", time, moved, by);
        EXPECT_EQ(blocks->GetNumberOfBlocks(), 5u);
        return vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(part));
    }

    static std::array<double, 3> vector(vtkFieldData* data, const char* name, vtkIdType i) {
        std::array<double, 3> value{};
        vtkDataArray* array = data->GetArray(name);
        EXPECT_TRUE(array) << name;
        if (array) array->GetTuple(i, value.data());
        return value;
    }
    /// A number of a state; the reader gives those of all states.
    static double number(vtkUnstructuredGrid* grid, const char* name, vtkIdType state) {
        vtkDataArray* array = grid->GetFieldData()->GetArray(name);
        EXPECT_TRUE(array) << name;
        return array ? array->GetTuple1(state) : 0;
    }
};

// By hand, kappa3 = 1/2: Phi = phi/kappa3 = 8e-5; a point at (x, z), centre of gravity at z = 1/2,
// moves by (x_body - base - Phi (z - 1/2), 0, Phi x - z_body).
TEST_F(WalkAnimation, BodyMovesAsItsPointsDo) {
    WalkCase c;
    c.machine.kappas = walking::set_b();
    write_walk_animation(folder_.string(), c, std::vector{some_snapshot(7)}, provenance_);
    vtkUnstructuredGrid* grid = read(body, 0);
    constexpr double rounding = 1e-10;  // of numbers below 1e-3 in single precision
    ASSERT_EQ(grid->GetNumberOfCells(), 6);
    std::set<vtkIdType> corners;
    for (vtkIdType cell = 0; cell < 6; ++cell) {
        ASSERT_EQ(grid->GetCell(cell)->GetNumberOfPoints(), 4);
        EXPECT_EQ(grid->GetCellData()->GetArray("part")->GetTuple1(cell), 2);
        for (vtkIdType k = 0; k < 4; ++k) corners.insert(grid->GetCell(cell)->GetPointId(k));
    }
    EXPECT_EQ(corners.size(), 8u);
    for (const vtkIdType corner : corners) {
        std::array<double, 3> p{};
        grid->GetPoint(corner, p.data());
        const auto d = vector(grid->GetPointData(), "displacement_", corner);
        EXPECT_NEAR(d[0], -2e-4 - 8e-5 * (p[2] - 0.5), rounding);
        EXPECT_EQ(d[1], 0);
        EXPECT_NEAR(d[2], 8e-5 * p[0] + 2e-5, rounding);
    }
    // Strips side by side, every second one marked.
    EXPECT_EQ(read(ground, 0)->GetNumberOfCells(), 30);
    EXPECT_EQ(read(ground_marked, 0)->GetNumberOfCells(), 30);
    EXPECT_EQ(read(ground_marked, 0)->GetCellData()->GetArray("part")->GetTuple1(29), 4);
}

// The reader moves the machine by its displacements, times what it is told.
TEST_F(WalkAnimation, ReadersMoveItMagnified) {
    WalkCase c;
    c.machine.kappas = walking::set_b();
    write_walk_animation(folder_.string(), c, std::vector{some_snapshot(7)}, provenance_);
    const double magnified = number(read(spots, 0), "magnification", 0);
    EXPECT_EQ(magnified, 500);
    std::array<double, 3> at_rest{}, moved{};
    read(spots, 0)->GetPoint(0, at_rest.data());
    const auto d = vector(read(spots, 0)->GetPointData(), "displacement_", 0);
    read(spots, 0, true, magnified)->GetPoint(0, moved.data());
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(moved[k], at_rest[k] + 500 * d[k], 1e-6) << k;  // single precision
    EXPECT_GT(std::abs(moved[0] - at_rest[0]), 0.05);
}

TEST_F(WalkAnimation, ForcesActOnTheBodyAndBalanceItsAcceleration) {
    WalkCase c;
    c.machine.kappas = walking::set_b();
    const auto snapshot = some_snapshot(7);
    write_walk_animation(folder_.string(), c, std::vector{snapshot}, provenance_);
    vtkUnstructuredGrid* grid = read(spots, 0);
    double x = 0, z = -c.machine.kappas.kappa4;
    for (int i = 0; i < grid->GetNumberOfPoints(); ++i)
        for (const char* name : {"normal_force_", "tangential_force_", "spring_force_"}) {
            const auto force = vector(grid->GetPointData(), name, i);
            x += force[0];
            z += force[2];
        }
    const auto due = acceleration(c.machine, spots_of(c.machine), snapshot.motion);
    constexpr double rounding = 1e-10;  // of numbers below 1e-3 in single precision
    EXPECT_NEAR(x, due.x, rounding);
    EXPECT_NEAR(z, -due.z, rounding);
    vtkDataArray* states = grid->GetPointData()->GetArray("contact_state");
    EXPECT_EQ(states->GetTuple1(0), 1);
    EXPECT_EQ(states->GetTuple1(1), 0);
    // Nothing else is in contact: colours span three states.
    for (vtkIdType i = 2; i < states->GetNumberOfTuples(); ++i) EXPECT_EQ(states->GetTuple1(i), 0);
}

TEST_F(WalkAnimation, IsInSiUnitsWithDimensions) {
    const WalkCase c = dimensional_case();
    const auto& machine = *c.dimensional;
    const std::vector snapshots{some_snapshot(7), some_snapshot(8)};
    write_walk_animation(folder_.string(), c, snapshots, provenance_);
    const double tau = std::sqrt(machine.mass / machine.tangential_stiffness);
    vtkUnstructuredGrid* grid = read(spots, 1.5 * tau);  // the last state
    EXPECT_DOUBLE_EQ(number(grid, "time_s", 1), tau);
    EXPECT_DOUBLE_EQ(number(grid, "run_time_s", 1), 8 * tau);
    // The left spot: k_z n upwards, k_x u backwards.
    const auto normal = vector(grid->GetPointData(), "normal_force_N_", 0);
    const auto tangential = vector(grid->GetPointData(), "tangential_force_N_", 0);
    EXPECT_FLOAT_EQ(normal[2], machine.normal_stiffness * 6e-5 * machine.half_width);
    EXPECT_FLOAT_EQ(tangential[0], -machine.tangential_stiffness * 1e-5 * machine.half_width);
    std::array<double, 3> spot{};
    grid->GetPoint(0, spot.data());
    EXPECT_EQ(spot[0], -machine.half_width);
    EXPECT_TRUE(grid->GetPointData()->HasArray("displacement_m_"));
    // The first state is at time 0; there is one file.
    EXPECT_EQ(number(grid, "time_s", 0), 0);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

// The front of the body's top moves most: (-2.4e-4, 1e-4); a fifth of b over its length is 769.
TEST_F(WalkAnimation, IsMagnifiedToAFifthOfTheHalfWidth) {
    WalkCase c;
    c.machine.kappas = walking::set_b();
    EXPECT_EQ(magnification(c.machine, std::vector{some_snapshot(7)}), 500);
    EXPECT_EQ(magnification(c.machine, {}), 1);
}

}  // namespace
}  // namespace tricontact::walking::walk_animation_test

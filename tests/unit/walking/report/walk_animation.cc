#include "walking/report/walk_animation.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>

#include "tests/unit/io/results/vtk_files.h"
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

class WalkAnimation : public io::VtkFiles {
  protected:
    vtkPolyData* read(const std::string& name) {
        reader_->SetFileName(at(name).c_str());
        reader_->Update();
        return reader_->GetOutput();
    }

    static std::array<double, 3> vector(vtkFieldData* data, const char* name, int i) {
        std::array<double, 3> value{};
        vtkDataArray* array = data->GetArray(name);
        EXPECT_TRUE(array) << name;
        if (array) array->GetTuple(i, value.data());
        return value;
    }

    vtkNew<vtkXMLPolyDataReader> reader_;
};

// By hand, kappa3 = 1/2: Phi = phi/kappa3 = 8e-5; a point at (x, z), centre of gravity at z = 1/2,
// moves by (x_body - base - Phi (z - 1/2), 0, Phi x - z_body).
TEST_F(WalkAnimation, BodyMovesAsItsPointsDo) {
    WalkCase c;
    c.machine.kappas = walking::set_b();
    write_walk_animation(folder_.string(), c, std::vector{some_snapshot(7)}, provenance_);
    vtkPolyData* poly = read("machine_000000.vtp");
    vtkPointData* data = poly->GetPointData();
    constexpr double rounding = 1e-10;  // of numbers below 1e-3 in single precision
    int n_corners = 0;
    for (vtkIdType cell = 0; cell < poly->GetNumberOfCells(); ++cell) {
        if (poly->GetCellData()->GetArray("part")->GetTuple1(cell) != 2) continue;
        vtkIdType n = 0;
        const vtkIdType* corners = nullptr;
        poly->GetCellPoints(cell, n, corners);
        for (vtkIdType k = 0; k < n; ++k, ++n_corners) {
            std::array<double, 3> p{};
            poly->GetPoint(corners[k], p.data());
            const auto d = vector(data, "displacement", static_cast<int>(corners[k]));
            EXPECT_NEAR(d[0], -2e-4 - 8e-5 * (p[2] - 0.5), rounding);
            EXPECT_EQ(d[1], 0);
            EXPECT_NEAR(d[2], 8e-5 * p[0] + 2e-5, rounding);
        }
    }
    EXPECT_EQ(n_corners, 6 * 4);
}

TEST_F(WalkAnimation, ForcesActOnTheBodyAndBalanceItsAcceleration) {
    WalkCase c;
    c.machine.kappas = walking::set_b();
    const auto snapshot = some_snapshot(7);
    write_walk_animation(folder_.string(), c, std::vector{snapshot}, provenance_);
    vtkPolyData* poly = read("machine_000000.vtp");
    double x = 0, z = -c.machine.kappas.kappa4;
    for (int i = 0; i < poly->GetNumberOfPoints(); ++i)
        for (const char* name : {"normal_force", "tangential_force", "spring_force"}) {
            const auto force = vector(poly->GetPointData(), name, i);
            x += force[0];
            z += force[2];
        }
    const auto due = acceleration(c.machine, spots_of(c.machine), snapshot.motion);
    constexpr double rounding = 1e-10;  // of numbers below 1e-3 in single precision
    EXPECT_NEAR(x, due.x, rounding);
    EXPECT_NEAR(z, -due.z, rounding);
    vtkDataArray* states = poly->GetPointData()->GetArray("contact_state");
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
    vtkPolyData* poly = read("machine_000001.vtp");
    EXPECT_DOUBLE_EQ(poly->GetFieldData()->GetArray("time_s")->GetTuple1(0), tau);
    EXPECT_DOUBLE_EQ(poly->GetFieldData()->GetArray("run_time_s")->GetTuple1(0), 8 * tau);
    EXPECT_NE(content("machine.pvd").find("timestep=\"0\" "), std::string::npos);
    // The left spot: k_z n upwards, k_x u backwards.
    const auto normal = vector(poly->GetPointData(), "normal_force_N", 0);
    const auto tangential = vector(poly->GetPointData(), "tangential_force_N", 0);
    EXPECT_FLOAT_EQ(normal[2], machine.normal_stiffness * 6e-5 * machine.half_width);
    EXPECT_FLOAT_EQ(tangential[0], -machine.tangential_stiffness * 1e-5 * machine.half_width);
    std::array<double, 3> spot{};
    poly->GetPoint(0, spot.data());
    EXPECT_EQ(spot[0], -machine.half_width);
    EXPECT_TRUE(poly->GetPointData()->HasArray("displacement_m"));
    EXPECT_NE(content("machine.pvd").find("file=\"machine_000001.vtp\""), std::string::npos);
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

// Files of element surfaces, interiors and meshes are read back with VTK's own readers.

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>

#include "contact/base/error.h"
#include "io/results/vtk_files.h"
#include "tests/unit/io/results/vtk_files.h"

namespace tricontact::io::vtk_elements_test {
namespace {

using contact::ContactState;
using contact::Interior;
using contact::Surface;

class VtkElements : public VtkFiles {
  protected:
    vtkUnstructuredGrid* read(const std::string& name) {
        reader_->SetFileName(at(name).c_str());
        reader_->Update();
        return reader_->GetOutput();
    }

    vtkNew<vtkXMLUnstructuredGridReader> reader_;
};

template <std::size_t N>
void expect_cell(vtkUnstructuredGrid* grid, vtkIdType id, int type, const std::array<int, N>& due) {
    EXPECT_EQ(grid->GetCellType(id), type);
    vtkNew<vtkIdList> nodes;
    grid->GetCellPoints(id, nodes);
    ASSERT_EQ(nodes->GetNumberOfIds(), static_cast<vtkIdType>(N));
    for (std::size_t k = 0; k < N; ++k)
        EXPECT_EQ(nodes->GetId(static_cast<vtkIdType>(k)), due[k]) << k;
}

void expect_bytes(vtkFieldData* data, const char* name, const std::vector<int>& due) {
    vtkDataArray* array = data->GetArray(name);
    ASSERT_TRUE(array) << name;
    EXPECT_EQ(array->GetDataType(), VTK_UNSIGNED_CHAR);
    ASSERT_EQ(array->GetNumberOfTuples(), static_cast<vtkIdType>(due.size())) << name;
    for (std::size_t i = 0; i < due.size(); ++i)
        EXPECT_EQ(array->GetTuple1(static_cast<vtkIdType>(i)), due[i]) << name << ' ' << i;
}

// Two elements side by side: 5 x 3 nodes, x fastest; no two values of any fields are the same.
Surface element_surface() {
    Surface s;
    s.layout = Surface::Layout::nodes;
    s.offset = {0.0011, -0.0007};
    for (int i = 0; i < 15; ++i) {
        s.node_x.push_back((i % 5) / 3e3);
        s.node_y.push_back((i / 5) / 7e3);
        s.contact_state.push_back(static_cast<ContactState>(i % 3));
    }
    // Corners, edges, centre.
    s.quads = {{0, 2, 12, 10, 1, 7, 11, 5, 6}, {2, 4, 14, 12, 3, 9, 13, 7, 8}};
    int field = 0;
    for (auto* values :
         {&s.normal_traction, &s.tangential_traction_x, &s.tangential_traction_y, &s.friction_bound,
          &s.displacement_x, &s.displacement_y, &s.displacement_z, &s.gap, &s.slip_x, &s.slip_y,
          &s.dissipation, &s.slip_path, &s.friction_work, &s.normal_traction_consistent,
          &s.tangential_traction_x_consistent, &s.tangential_traction_y_consistent}) {
        ++field;
        for (int i = 0; i < 15; ++i) values->push_back(field + i / 17.);
    }
    return s;
}

TEST_F(VtkElements, AnElementSurfaceReadsBackExactlyAsPointDataOfQuadrilaterals) {
    const Surface s = element_surface();
    VtkSeries out = series("surface");
    out.add(1. / 3, s);
    vtkUnstructuredGrid* grid = read("surface_000000.vtu");
    ASSERT_EQ(grid->GetNumberOfPoints(), 15);
    ASSERT_EQ(grid->GetNumberOfCells(), 2);
    for (int k = 0; k < 2; ++k) expect_cell(grid, k, VTK_BIQUADRATIC_QUAD, s.quads[k]);
    for (int i = 0; i < 15; ++i) {
        EXPECT_EQ(grid->GetPoint(i)[0], s.node_x[i]);
        EXPECT_EQ(grid->GetPoint(i)[1], s.node_y[i]);
        EXPECT_EQ(grid->GetPoint(i)[2], 0);
    }
    vtkPointData* data = grid->GetPointData();
    expect_scalar(data, "normal_traction_Pa", s.normal_traction);
    expect_vector(data, "tangential_traction_Pa", s.tangential_traction_x, s.tangential_traction_y,
                  {}, 1);
    expect_scalar(data, "normal_traction_consistent_Pa", s.normal_traction_consistent);
    expect_vector(data, "tangential_traction_consistent_Pa", s.tangential_traction_x_consistent,
                  s.tangential_traction_y_consistent, {}, 1);
    expect_scalar(data, "friction_bound_Pa", s.friction_bound);
    expect_vector(data, "displacement_m", s.displacement_x, s.displacement_y, s.displacement_z, -1);
    expect_gap(data, s);
    expect_vector(data, "slip_m", s.slip_x, s.slip_y, {}, 1);
    expect_scalar(data, "dissipation_J_per_m2", s.dissipation);
    expect_scalar(data, "slip_path_m", s.slip_path);
    expect_scalar(data, "friction_work_J_per_m2", s.friction_work);
    expect_bytes(data, "contact_state", {0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2});
    expect_numbers(grid->GetFieldData(), "time_periods", {1. / 3});
    expect_numbers(grid->GetFieldData(), "indenter_position_m", {0.0011, -0.0007, 0});
    expect_origin(grid->GetFieldData());
}

// VTK's shape functions see the nodes in the order in which they are meant: the centre of the
// second element is where it should be, the four corners are its first four nodes.
TEST_F(VtkElements, NodesOfAQuadrilateralStandInVtksOrder) {
    VtkSeries out = series("surface");
    out.add(0, element_surface());
    vtkCell* cell = read("surface_000000.vtu")->GetCell(1);
    const double quarter[3] = {0.25, 0.75, 0};
    double x[3], weights[9];
    int sub = 0;
    cell->EvaluateLocation(sub, quarter, x, weights);
    // Straight sides: bilinear; 1e-15 of a millimetre is rounding.
    EXPECT_NEAR(x[0], 2.5 / 3e3, 1e-18);
    EXPECT_NEAR(x[1], 1.5 / 7e3, 1e-18);
}

TEST_F(VtkElements, FieldsThatAModelLacksAreLeftOut) {
    Surface s = element_surface();
    for (auto* field : {&s.slip_path, &s.friction_work, &s.normal_traction_consistent,
                        &s.tangential_traction_x_consistent, &s.tangential_traction_y_consistent})
        field->clear();
    VtkSeries out = series("surface");
    out.add(0, s);
    vtkPointData* data = read("surface_000000.vtu")->GetPointData();
    for (const char* name : {"slip_path_m", "friction_work_J_per_m2",
                             "normal_traction_consistent_Pa", "tangential_traction_consistent_Pa"})
        EXPECT_FALSE(data->GetArray(name)) << name;
    EXPECT_TRUE(data->GetArray("normal_traction_Pa"));
}

// Two cubes of edge 2 mm on top of each other, 3 x 3 x 5 nodes, x fastest.
Interior two_cubes() {
    Interior in;
    for (int i = 0; i < 45; ++i) {
        in.points.push_back({(i % 3) * 1e-3, (i / 3 % 3) * 1e-3, (i / 9) * 1e-3 - 4e-3});
        in.displacement.push_back({i / 7., i / 11., i / 13.});
        in.stress.push_back({i / 3., 1 + i / 7., 2 - i / 9., i / 17., 1 - i / 19., i / 23.});
    }
    // Corners, edges, faces (x-, x+, y-, y+, z-, z+), centre.
    const std::array<int, 27> lower = {0,  2,  8, 6,  18, 20, 26, 24, 1,  5,  7, 3,  19, 23,
                                       25, 21, 9, 11, 17, 15, 12, 14, 10, 16, 4, 22, 13};
    std::array<int, 27> upper = lower;
    for (int& node : upper) node += 18;
    in.hexes = {lower, upper};
    in.region = {1, 0};
    in.energy_density = {1. / 3, 2. / 3};
    in.strain_energy = 1. / 7;
    in.applied = {1. / 3, -1. / 9, -21.1};
    in.base_reaction = {-1. / 3, 1. / 9, 21.1};
    return in;
}

TEST_F(VtkElements, AnInteriorReadsBackExactly) {
    const Interior in = two_cubes();
    VtkSeries out = series("volume");
    out.add(2.25, in);
    out.finish();
    EXPECT_NE(content("volume.pvd")
                  .find("timestep=\"2.25\" group=\"\" part=\"0\" "
                        "file=\"volume_000000.vtu\""),
              std::string::npos);
    vtkUnstructuredGrid* grid = read("volume_000000.vtu");
    ASSERT_EQ(grid->GetNumberOfPoints(), 45);
    ASSERT_EQ(grid->GetNumberOfCells(), 2);
    for (int k = 0; k < 2; ++k) expect_cell(grid, k, VTK_TRIQUADRATIC_HEXAHEDRON, in.hexes[k]);
    vtkDataArray* displacement = grid->GetPointData()->GetArray("displacement_m");
    vtkDataArray* stress = grid->GetPointData()->GetArray("stress_Pa");
    ASSERT_TRUE(displacement && stress);
    ASSERT_EQ(displacement->GetNumberOfComponents(), 3);
    ASSERT_EQ(stress->GetNumberOfComponents(), 6);
    const std::array<std::string, 6> names = {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
    for (int c = 0; c < 6; ++c) EXPECT_EQ(stress->GetComponentName(c), names[c]);
    for (int i = 0; i < 45; ++i) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(grid->GetPoint(i)[c], in.points[i][c]);
            EXPECT_EQ(displacement->GetComponent(i, c), in_file(in.displacement[i][c]));
        }
        for (int c = 0; c < 6; ++c) EXPECT_EQ(stress->GetComponent(i, c), in_file(in.stress[i][c]));
    }
    expect_bytes(grid->GetCellData(), "region", {1, 0});
    expect_scalar(grid->GetCellData(), "strain_energy_density_J_per_m3", in.energy_density);
    vtkFieldData* fields = grid->GetFieldData();
    expect_numbers(fields, "time_periods", {2.25});
    expect_numbers(fields, "strain_energy_J", {1. / 7});
    expect_numbers(fields, "applied_force_N", {1. / 3, -1. / 9, -21.1});
    expect_numbers(fields, "base_reaction_N", {-1. / 3, 1. / 9, 21.1});
    expect_origin(fields);
}

TEST_F(VtkElements, NodesOfAHexahedronStandInVtksOrder) {
    VtkSeries out = series("volume");
    out.add(0, two_cubes());
    vtkUnstructuredGrid* grid = read("volume_000000.vtu");
    const double at_quarters[3] = {0.25, 0.5, 0.75};
    double x[3], weights[27];
    int sub = 0;
    grid->GetCell(1)->EvaluateLocation(sub, at_quarters, x, weights);
    for (int c = 0; c < 3; ++c)  // 1e-15 of a millimetre is rounding
        EXPECT_NEAR(x[c], (std::array<double, 3>{0.5e-3, 1e-3, -0.5e-3})[c], 1e-18);
}

// Uniaxial tension: von Mises' stress is the tension, the pressure -1/3 of it. Pure shear: sqrt 3
// times the shear. Hydrostatic: none. Each in all directions.
TEST_F(VtkElements, StressMeasuresAreThoseOfKnownStates) {
    Interior in = two_cubes();
    for (auto& stress : in.stress) stress = {};
    for (int c = 0; c < 3; ++c) in.stress[c][c] = 2e6;
    for (int c = 3; c < 6; ++c) in.stress[c][c] = -1e6;
    in.stress[6] = {-3e6, -3e6, -3e6, 0, 0, 0};
    VtkSeries out = series("volume");
    out.add(0, in);
    vtkPointData* data = read("volume_000000.vtu")->GetPointData();
    vtkDataArray* mises = data->GetArray("von_mises_Pa");
    vtkDataArray* pressure = data->GetArray("pressure_Pa");
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

TEST_F(VtkElements, TheSameStateGivesTheSameBytes) {
    VtkSeries first = series("first"), second = series("second");
    for (auto* out : {&first, &second}) {
        out->add(0.5, two_cubes());
        out->add(0.5, element_surface());
    }
    EXPECT_EQ(content("first_000000.vtu"), content("second_000000.vtu"));
    EXPECT_EQ(content("first_000001.vtu"), content("second_000001.vtu"));
    EXPECT_NE(content("first_000000.vtu"), content("first_000001.vtu"));
}

TEST_F(VtkElements, FieldsOfAWrongSizeAreRefused) {
    VtkSeries out = series("any");
    Surface surface = element_surface();
    surface.normal_traction_consistent.pop_back();
    EXPECT_THROW(out.add(0, surface), std::invalid_argument);
    Interior interior = two_cubes();
    interior.stress.pop_back();
    EXPECT_THROW(out.add(0, interior), std::invalid_argument);
    interior = two_cubes();
    interior.region.pop_back();
    EXPECT_THROW(out.add(0, interior), std::invalid_argument);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

const std::vector<std::array<double, 3>> box_points = {
    {0, 0, -1. / 3}, {1, 0, -1. / 3}, {1, 1, -1. / 3}, {0, 1, -1. / 3},
    {0, 0, 0},       {1, 0, 0},       {1, 1, 0},       {0, 1, 0}};
const std::vector<std::array<int, 8>> box = {{0, 1, 2, 3, 4, 5, 6, 7}};
const std::vector<std::array<int, 4>> box_faces = {{4, 5, 6, 7}, {0, 1, 2, 3}};
const std::vector<std::uint8_t> box_regions = {1}, box_boundaries = {0, 2};

MeshView box_mesh() {
    return {box_points,
            box,
            box_regions,
            box_faces,
            box_boundaries,
            {"layer", "lower_layer"},
            {"contact", "free_top", "base"}};
}

TEST_F(VtkElements, AMeshReadsBackWithRegionsAndBoundaries) {
    write_mesh_vtu(at("mesh.vtu"), box_mesh(), provenance_);
    vtkUnstructuredGrid* grid = read("mesh.vtu");
    ASSERT_EQ(grid->GetNumberOfPoints(), 8);
    ASSERT_EQ(grid->GetNumberOfCells(), 3);
    for (int i = 0; i < 8; ++i)
        for (int c = 0; c < 3; ++c) EXPECT_EQ(grid->GetPoint(i)[c], box_points[i][c]);
    expect_cell(grid, 0, VTK_HEXAHEDRON, box[0]);
    expect_cell(grid, 1, VTK_QUAD, box_faces[0]);
    expect_cell(grid, 2, VTK_QUAD, box_faces[1]);
    expect_bytes(grid->GetCellData(), "dimension", {3, 2, 2});
    expect_bytes(grid->GetCellData(), "region", {1, 255, 255});
    expect_bytes(grid->GetCellData(), "boundary", {255, 0, 2});
    auto* names =
        vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("boundary_names"));
    ASSERT_TRUE(names);
    ASSERT_EQ(names->GetNumberOfValues(), 3);
    EXPECT_EQ(names->GetValue(2), "base");
    names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("region_names"));
    ASSERT_TRUE(names);
    EXPECT_EQ(names->GetValue(1), "lower_layer");
    expect_origin(grid->GetFieldData());
}

TEST_F(VtkElements, AMeshOfUnequalListsOrNoFolderIsRefused) {
    MeshView mesh = box_mesh();
    mesh.boundaries = mesh.boundaries.first(1);
    EXPECT_THROW(write_mesh_vtu(at("mesh.vtu"), mesh, provenance_), std::invalid_argument);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
    EXPECT_THROW(write_mesh_vtu(at("missing/mesh.vtu"), box_mesh(), provenance_),
                 contact::InputError);
}

}  // namespace
}  // namespace tricontact::io::vtk_elements_test

// A mesh is read back with VTK's own reader.

#include "io/results/vtk_files.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "contact/base/error.h"
#include "tests/unit/io/results/vtk_files.h"

namespace tricontact::io::vtk_files_test {
namespace {

class VtkMesh : public VtkFiles {
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

TEST_F(VtkMesh, AMeshReadsBackWithRegionsAndBoundaries) {
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

TEST_F(VtkMesh, AMeshOfUnequalListsOrNoFolderIsRefused) {
    MeshView mesh = box_mesh();
    mesh.boundaries = mesh.boundaries.first(1);
    EXPECT_THROW(write_mesh_vtu(at("mesh.vtu"), mesh, provenance_), std::invalid_argument);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
    EXPECT_THROW(write_mesh_vtu(at("missing/mesh.vtu"), box_mesh(), provenance_),
                 contact::InputError);
}

}  // namespace
}  // namespace tricontact::io::vtk_files_test

// A comparison's fields, read back with VTK's own readers.

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "benchmarks/report/comparison_output.h"
#include "tests/unit/benchmarks/report/hertz_comparison.h"
#include "tests/unit/io/results/vtk_files.h"

namespace tricontact::benchmarks::comparison_vtk_test {
namespace {

using ComparisonVtk = io::VtkFiles;

// Pressures of the code are 1.014 times Hertz': the difference is 0.014 times that.
void expect_fields(vtkPointData* data, const MeshResult& mesh) {
    const HertzFields fields;
    std::vector<double> code, exact;
    for (const SurfacePoint& point : mesh.points) {
        code.push_back(point.values.pressure);
        exact.push_back(fields.at(point.x, point.y).pressure);
    }
    io::expect_scalar(data, "pressure_Pa", code);
    io::expect_scalar(data, "pressure_reference_Pa", exact);
    io::expect_scalar(data, "pressure_reference_bar_Pa",
                      std::vector(exact.size(), fields.p0 / 200));
    for (std::size_t i = 0; i < exact.size(); ++i)
        EXPECT_NEAR(data->GetArray("pressure_difference_Pa")->GetTuple1(vtkIdType(i)),
                    .014 * exact[i], 1e-6 * fields.p0);
    EXPECT_NEAR(data->GetArray("traction_difference_Pa")->GetTuple3(0)[0], .014 * exact[0] / 20,
                1e-6 * fields.p0);
    EXPECT_FALSE(data->HasArray("displacement_Pa") || data->HasArray("gap_m"));
}

TEST_F(ComparisonVtk, PointsOfARadiusAreVerticesAndALine) {
    const Comparison comparison = hertz_comparison();
    const MeshResult& mesh = comparison.meshes.back();
    const io::VtkFile file = comparison_vtk(comparison, mesh, provenance_);
    EXPECT_EQ(file.extension, ".vtp");
    std::ofstream(at("a.vtp"), std::ios::binary) << file.bytes;
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(at("a.vtp").c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    EXPECT_EQ(data->GetNumberOfVerts(), static_cast<vtkIdType>(mesh.points.size()));
    EXPECT_EQ(data->GetNumberOfLines(), 1);
    io::expect_origin(data->GetFieldData());
    expect_fields(data->GetPointData(), mesh);
}

TEST_F(ComparisonVtk, FacesAreCellsOfTheirOwnTypes) {
    Comparison comparison = hertz_comparison(Geometry::spatial);
    MeshResult& mesh = comparison.meshes.back();
    mesh.faces.offsets = {0, 3, 9, 13, 21, 30};
    for (int i = 0; i < 30; ++i) mesh.faces.points.push_back(i);
    const io::VtkFile file = comparison_vtk(comparison, mesh, provenance_);
    EXPECT_EQ(file.extension, ".vtu");
    std::ofstream(at("a.vtu"), std::ios::binary) << file.bytes;
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(at("a.vtu").c_str());
    reader->Update();
    vtkUnstructuredGrid* data = reader->GetOutput();
    std::vector<int> types;
    for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) types.push_back(data->GetCellType(i));
    EXPECT_EQ(types, (std::vector<int>{VTK_TRIANGLE, VTK_QUADRATIC_TRIANGLE, VTK_QUAD,
                                       VTK_QUADRATIC_QUAD, VTK_BIQUADRATIC_QUAD}));
    expect_fields(data->GetPointData(), mesh);
}

}  // namespace
}  // namespace tricontact::benchmarks::comparison_vtk_test

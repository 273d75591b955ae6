// Written files are read back with VTK's own readers.

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <filesystem>
#include <limits>

#include "contact/base/error.h"
#include "io/results/vtk_files.h"
#include "tests/unit/io/results/vtk_files.h"

namespace tricontact::io::vtk_series_test {
namespace {

namespace fs = std::filesystem;
using contact::ContactState;
using contact::Surface;

// Every number of every field is different, none is short in binary or decimal.
Surface surface_of(Surface::Layout layout, int n_x, int n_y) {
    Surface s;
    s.layout = layout;
    s.n_x = n_x;
    s.n_y = n_y;
    s.first = {-0.003, -0.002};
    s.spacing = {2e-4, 3e-4};
    s.offset = {0.0011, -0.0007};
    int field = 0;
    auto fill = [&](std::vector<double>& values) {
        ++field;
        values.resize(s.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = field + static_cast<double>(i) / 7;
    };
    for (auto* values :
         {&s.normal_traction, &s.tangential_traction_x, &s.tangential_traction_y, &s.friction_bound,
          &s.displacement_x, &s.displacement_y, &s.displacement_z, &s.gap, &s.slip_x, &s.slip_y,
          &s.dissipation, &s.slip_path, &s.friction_work})
        fill(*values);
    if (layout == Surface::Layout::line)
        for (auto* values : {&s.normal_line_load, &s.tangential_line_load}) fill(*values);
    for (std::size_t i = 0; i < s.size(); ++i)
        s.contact_state.push_back(static_cast<ContactState>(i % 3));
    return s;
}

using Vtk = VtkFiles;

void expect_fields(vtkFieldData* data, const Surface& s) {
    expect_scalar(data, "normal_traction_Pa", s.normal_traction);
    expect_vector(data, "tangential_traction_Pa", s.tangential_traction_x, s.tangential_traction_y,
                  {}, 1);
    expect_scalar(data, "friction_bound_Pa", s.friction_bound);
    expect_vector(data, "displacement_m", s.displacement_x, s.displacement_y, s.displacement_z, -1);
    expect_gap(data, s);
    expect_vector(data, "slip_m", s.slip_x, s.slip_y, {}, 1);
    expect_scalar(data, "dissipation_J_per_m2", s.dissipation);
    expect_scalar(data, "slip_path_m", s.slip_path);
    expect_scalar(data, "friction_work_J_per_m2", s.friction_work);
    vtkDataArray* states = data->GetArray("contact_state");
    ASSERT_TRUE(states);
    EXPECT_EQ(states->GetDataType(), VTK_UNSIGNED_CHAR);
    for (std::size_t i = 0; i < s.size(); ++i)
        ASSERT_EQ(states->GetTuple1(static_cast<vtkIdType>(i)), static_cast<double>(i % 3));
}

void expect_provenance(vtkFieldData* data, double phase, const Surface& s) {
    expect_numbers(data, "time_periods", {phase});
    expect_numbers(data, "indenter_position_m", {s.offset[0], s.offset[1], 0});
    expect_origin(data);
}

TEST_F(Vtk, AGridReadsBackExactlyAsPointData) {
    const Surface s = surface_of(Surface::Layout::grid, 31, 20);
    VtkSeries out = series("surface");
    out.add(1. / 3, s);

    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(at("surface_000000.vti").c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfPoints(), 31 * 20);
    expect_fields(image->GetPointData(), s);
    EXPECT_EQ(image->GetCellData()->GetNumberOfArrays(), 0);
    expect_provenance(image->GetFieldData(), 1. / 3, s);
    // Point k = i + 31 j is point (i, j): 12 digits, origins are written in decimal.
    for (const auto& [i, j] : {std::pair(0, 0), std::pair(30, 0), std::pair(4, 19)}) {
        const double* point = image->GetPoint(i + 31 * j);
        EXPECT_NEAR(point[0], s.x(i), 1e-12 * 31 * s.spacing[0]);
        EXPECT_NEAR(point[1], s.y(j), 1e-12 * 31 * s.spacing[1]);
    }
}

// A row of a cylinder's cells has an extent across.
TEST_F(Vtk, ASingleRowReadsBackExactlyAsCellData) {
    const Surface s = surface_of(Surface::Layout::grid, 31, 1);
    VtkSeries out = series("surface");
    out.add(1. / 3, s);

    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(at("surface_000000.vti").c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetNumberOfCells(), 31);
    expect_fields(image->GetCellData(), s);
    double bounds[6];
    image->GetCellBounds(30, bounds);
    EXPECT_NEAR((bounds[0] + bounds[1]) / 2, s.x(30), 1e-12 * 31 * s.spacing[0]);
    EXPECT_NEAR(bounds[3] - bounds[2], s.spacing[1], 1e-12 * s.spacing[1]);
}

TEST_F(Vtk, ALineReadsBackExactlyAsPointData) {
    const Surface s = surface_of(Surface::Layout::line, 101, 1);
    VtkSeries out = series("bed");
    out.add(2.25, s);

    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(at("bed_000000.vtp").c_str());
    reader->Update();
    vtkPolyData* line = reader->GetOutput();
    ASSERT_EQ(line->GetNumberOfPoints(), 101);
    EXPECT_EQ(line->GetNumberOfVerts(), 101);
    EXPECT_EQ(line->GetNumberOfLines(), 1);
    expect_fields(line->GetPointData(), s);
    expect_scalar(line->GetPointData(), "normal_line_load_N_per_m", s.normal_line_load);
    expect_scalar(line->GetPointData(), "tangential_line_load_N_per_m", s.tangential_line_load);
    expect_provenance(line->GetFieldData(), 2.25, s);
    for (const int i : {0, 50, 100}) {
        EXPECT_EQ(line->GetPoint(i)[0], s.x(i));
        EXPECT_EQ(line->GetPoint(i)[1], s.first[1]);
    }
}

TEST_F(Vtk, FieldsThatAModelLacksAreLeftOutOrZero) {
    Surface s = surface_of(Surface::Layout::line, 10, 1);
    s.gap.clear();
    s.slip_y.clear();
    VtkSeries out = series("bed");
    out.add(0, s);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(at("bed_000000.vtp").c_str());
    reader->Update();
    vtkPointData* data = reader->GetOutput()->GetPointData();
    EXPECT_FALSE(data->GetArray("gap_m"));
    expect_vector(data, "slip_m", s.slip_x, std::vector<double>(10, 0.), {}, 1);
}

TEST_F(Vtk, InfiniteGapsOutsideTheIndenterSurvive) {
    Surface s = surface_of(Surface::Layout::grid, 4, 4);
    s.gap[6] = std::numeric_limits<double>::infinity();
    VtkSeries out = series("surface");
    out.add(0, s);
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(at("surface_000000.vti").c_str());
    reader->Update();
    expect_gap(reader->GetOutput()->GetPointData(), s);
}

TEST_F(Vtk, TheSameSurfaceGivesTheSameBytes) {
    const Surface s = surface_of(Surface::Layout::grid, 64, 48);
    VtkSeries first = series("first"), second = series("second");
    for (auto* out : {&first, &second}) {
        out->add(0.5, s);
        out->add(0.75, s);
    }
    EXPECT_EQ(content("first_000000.vti"), content("second_000000.vti"));
    EXPECT_NE(content("first_000000.vti"), content("first_000001.vti"));
    EXPECT_LT(content("first_000000.vti").size(), 64U * 48 * (11 * 8 + 1)) << "not compressed";
}

TEST_F(Vtk, TheCollectionListsFilesByPhase) {
    VtkSeries out = series("a&b");
    const Surface s = surface_of(Surface::Layout::line, 5, 1);
    out.add(0, s);
    out.add(0.25, s);
    out.finish();
    EXPECT_EQ(content("a&b.pvd"),
              "<?xml version=\"1.0\"?>\n"
              "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
              "  <Collection>\n"
              "    <DataSet timestep=\"0\" group=\"\" part=\"0\" file=\"a&amp;b_000000.vtp\"/>\n"
              "    <DataSet timestep=\"0.25\" group=\"\" part=\"0\" file=\"a&amp;b_000001.vtp\"/>\n"
              "  </Collection>\n"
              "</VTKFile>\n");
}

// A rerun writes over the files; what it has not come to is listed no more.
TEST_F(Vtk, ARerunGivesTheSameFiles) {
    const Surface large = surface_of(Surface::Layout::grid, 64, 48);
    const Surface small = surface_of(Surface::Layout::grid, 5, 4);
    VtkSeries before = series("surface"), other = series("other");
    for (const double time : {0., 1., 2.}) before.add(time, large);
    before.finish();
    VtkSeries rerun = series("surface");
    for (auto* out : {&rerun, &other}) {
        out->add(0, small);
        out->add(1, large);
    }
    rerun.finish();
    for (const std::string number : {"0", "1"})
        EXPECT_EQ(content("surface_00000" + number + ".vti"),
                  content("other_00000" + number + ".vti"));
    EXPECT_EQ(content("surface.pvd").find("surface_000002"), std::string::npos);
}

// States of one time come before it as far apart as the following ones; later ones share the gap.
TEST_F(Vtk, StatesOfOneTimeAreSetApart) {
    EXPECT_EQ(times_apart({0, 0, 0, 0.25, 0.5}), (std::vector{-0.5, -0.25, 0., 0.25, 0.5}));
    EXPECT_EQ(times_apart({0, 1, 1, 2}), (std::vector{0., 0.5, 1., 2.}));
    EXPECT_EQ(times_apart({3, 3}), (std::vector{2., 3.}));
    EXPECT_TRUE(times_apart({}).empty());
}

// Arrays are compressed in blocks of 1 MiB: three and a smaller one of the vectors, exactly two of
// the numbers.
TEST_F(Vtk, AGridOfSeveralBlocksReadsBackExactly) {
    const Surface s = surface_of(Surface::Layout::grid, 1024, 512);
    VtkSeries out = series("surface");
    out.add(0, s);
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(at("surface_000000.vti").c_str());
    reader->Update();
    expect_fields(reader->GetOutput()->GetPointData(), s);
}

TEST_F(Vtk, FieldsOfAWrongSizeAreRefused) {
    Surface s = surface_of(Surface::Layout::grid, 5, 4);
    s.gap.pop_back();
    VtkSeries out = series("surface");
    EXPECT_THROW(out.add(0, s), std::invalid_argument);
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Vtk, AFolderThatVanishedIsAnInputError) {
    fs::remove_all(folder_);
    VtkSeries out = series("surface");
    EXPECT_THROW(out.add(0, surface_of(Surface::Layout::grid, 5, 4)), contact::InputError);
    EXPECT_THROW(out.finish(), contact::InputError);
}

}  // namespace
}  // namespace tricontact::io::vtk_series_test

// Insides on a grid are read back with VTK's own reader.

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkXMLRectilinearGridReader.h>

#include "tests/unit/io/results/vtk_files.h"

namespace tricontact::io::vtk_rectilinear_test {
namespace {

using contact::Interior;
using VtkRectilinear = VtkFiles;

// 3 x 2 x 4 points at unequal distances; no two values are the same.
Interior grid() {
    Interior in;
    in.axes = {std::vector<double>{-1. / 3, 0, 1. / 7}, {0, 1e-3}, {-1. / 9, -2e-2, -1e-2, 0}};
    for (int i = 0; i < 24; ++i) {
        in.displacement.push_back({i / 7., i / 11., i / 13.});
        in.stress.push_back({i / 3., 1 + i / 7., 2 - i / 9., i / 17., 1 - i / 19., i / 23.});
    }
    in.strain_energy = 1. / 7;
    in.applied = {1. / 3, -1. / 9, -21.1};
    return in;
}

TEST_F(VtkRectilinear, AGridReadsBackExactly) {
    const Interior in = grid();
    VtkSeries out = series("volume");
    out.add(0.25, in);
    out.finish();
    EXPECT_NE(content("volume.pvd").find("file=\"volume_000000.vtr\""), std::string::npos);
    vtkNew<vtkXMLRectilinearGridReader> reader;
    reader->SetFileName(at("volume_000000.vtr").c_str());
    reader->Update();
    vtkRectilinearGrid* read = reader->GetOutput();
    ASSERT_EQ(read->GetNumberOfPoints(), 24);
    vtkPointData* data = read->GetPointData();
    vtkDataArray *displacement = data->GetArray("displacement_m"),
                 *stress = data->GetArray("stress_Pa"), *mises = data->GetArray("von_mises_Pa"),
                 *pressure = data->GetArray("pressure_Pa");
    ASSERT_TRUE(displacement && stress && mises && pressure);
    EXPECT_STREQ(stress->GetComponentName(4), "YZ");
    for (int i = 0; i < 24; ++i) {
        const auto position = in.position(i);
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(read->GetPoint(i)[c], position[c]);
            EXPECT_EQ(displacement->GetComponent(i, c), in_file(in.displacement[i][c]));
        }
        for (int c = 0; c < 6; ++c) EXPECT_EQ(stress->GetComponent(i, c), in_file(in.stress[i][c]));
        EXPECT_EQ(mises->GetTuple1(i), in_file(contact::von_mises(in.stress[i])));
        EXPECT_EQ(pressure->GetTuple1(i), in_file(contact::mean_pressure(in.stress[i])));
    }
    vtkFieldData* fields = read->GetFieldData();
    expect_numbers(fields, "time_periods", {0.25});
    expect_numbers(fields, "strain_energy_J", {1. / 7});
    expect_numbers(fields, "applied_force_N", {1. / 3, -1. / 9, -21.1});
    EXPECT_FALSE(fields->GetArray("base_reaction_N"));  // nobody computed it
    expect_origin(fields);
}

// One content, one file: names of arrays that VTK makes up hold addresses.
TEST_F(VtkRectilinear, FilesOfEqualGridsAreEqualByteForByte) {
    VtkSeries out = series("volume");
    const Interior in = grid(), same = grid();
    out.add(0.25, in);
    out.add(0.25, same);
    out.finish();
    EXPECT_EQ(content("volume_000000.vtr"), content("volume_000001.vtr"));
}

TEST_F(VtkRectilinear, FieldsOfAWrongSizeAreRefused) {
    Interior in = grid();
    in.stress.pop_back();
    EXPECT_THROW(series("any").add(0, in), std::invalid_argument);
    in = grid();
    in.axes[2].pop_back();
    EXPECT_THROW(series("any").add(0, in), std::invalid_argument);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace tricontact::io::vtk_rectilinear_test

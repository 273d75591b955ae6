#include "benchmarks/submissions/vtk_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "benchmarks/submissions/mesh_stream.h"
#include "benchmarks/submissions/read_field.h"
#include "contact/base/error.h"
#include "tests/paths.h"

namespace tricontact::benchmarks::vtk_file_test {
namespace {

namespace fs = std::filesystem;

const std::string folder = paths::source("tests/benchmarks/");

MeshField field_of(const std::string& name, const std::string& set = "") {
    return read_field({folder + name, set, ""});
}

std::string message_of(const std::string& file) {
    try {
        read_field({file, "", ""});
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

// Every file holds a block, -3 to 3 along x and y, -2 to 0 along z, of 36 bricks of one layer, with
// the pressure sqrt(1 - (r/2.6)^2) on top.
double pressure_at(double r) {
    return std::sqrt(std::max(0., 1 - r * r / 2.6 / 2.6));
}

class VtkFile : public testing::TestWithParam<const char*> {};

TEST_P(VtkFile, SurfaceOfABlockIsItsTop) {
    const MeshField field = field_of(std::string("formats/") + GetParam());
    const bool is_quadratic = std::string_view(GetParam()).starts_with("layer20");
    ASSERT_EQ(field.size(), is_quadratic ? 133U : 49U);
    ASSERT_EQ(field.faces.size(), 36);
    const auto& x = field.find(Meaning::x)->values;
    const auto& y = field.find(Meaning::y)->values;
    for (std::size_t i = 0; i < field.size(); ++i) {
        EXPECT_EQ(field.find(Meaning::z)->values[i], 0);
        EXPECT_NEAR(field.find(Meaning::pressure)->values[i], pressure_at(std::hypot(x[i], y[i])),
                    1e-6);  // EnSight has single precision
    }
    // Corners of each face go round it, middle nodes follow.
    for (int f = 0; f < field.faces.size(); ++f) {
        const auto begin =
            static_cast<std::size_t>(field.faces.offsets[static_cast<std::size_t>(f)]);
        double area = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto a = static_cast<std::size_t>(field.faces.points[begin + k]),
                       b = static_cast<std::size_t>(field.faces.points[begin + (k + 1) % 4]);
            area += (x[a] * y[b] - x[b] * y[a]) / 2;
            if (!is_quadratic) continue;
            const auto m = static_cast<std::size_t>(field.faces.points[begin + 4 + k]);
            EXPECT_DOUBLE_EQ(x[m], (x[a] + x[b]) / 2);
            EXPECT_DOUBLE_EQ(y[m], (y[a] + y[b]) / 2);
        }
        EXPECT_DOUBLE_EQ(std::abs(area), 1);
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, VtkFile,
                         testing::Values("layer.vtu", "layer20.vtu", "layer.vtk", "layer.e",
                                         "layer.case", "layer.cgns", "layer.vtkhdf", "layer.pvtu",
                                         "pieces.pvd", "run.pvd", "blocks.vtm"),
                         [](const auto& file) {
                             std::string name = file.param;
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

TEST(VtkFiles, ValuesAtCellsStandAtTheirCentresWithAreas) {
    const MeshField field = field_of("formats/surface.vtp");
    ASSERT_EQ(field.size(), 36U);
    EXPECT_EQ(field.faces.size(), 0);
    for (std::size_t i = 0; i < field.size(); ++i) {
        EXPECT_DOUBLE_EQ(field.find(Meaning::area)->values[i], 1);
        EXPECT_NEAR(field.find(Meaning::pressure)->values[i],
                    pressure_at(std::hypot(field.find(Meaning::x)->values[i],
                                           field.find(Meaning::y)->values[i])),
                    1e-12);
    }
}

TEST(VtkFiles, OfAPlaneBodyTheRimIsRead) {
    const MeshField field = field_of("formats/flat.vtu");
    ASSERT_EQ(field.size(), 11U);
    EXPECT_FALSE(field.find(Meaning::y));
    const auto& x = field.find(Meaning::x)->values;
    for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_DOUBLE_EQ(x[i], .5 * static_cast<double>(i));
        EXPECT_NEAR(field.find(Meaning::displacement_z)->values[i], -pressure_at(x[i]), 1e-12);
    }
}

TEST(VtkFiles, SetsAreNamed) {
    EXPECT_EQ(field_of("formats/blocks.vtm", "layer").size(), 49U);
    EXPECT_THROW(field_of("formats/blocks.vtm", "ball"), contact::InputError) << "no contact there";
    EXPECT_THROW(field_of("formats/blocks.vtm", "floor"), contact::InputError);
}

TEST(VtkFiles, WithoutContactValuesAreRefusedByTheirFields) {
    EXPECT_EQ(message_of(folder + "foreign/getfem_q2_1.vtu"),
              folder +
                  "foreign/getfem_q2_1.vtu: no pressure, traction, nodal force or stress; the "
                  "file has u; write the contact pressure, for example as contact_pressure");
}

TEST(VtkFiles, BrokenOnesAreOneErrorEach) {
    const fs::path work = fs::temp_directory_path() / ("vtk_file_test_" + std::to_string(getpid()));
    fs::create_directories(work);
    for (const char* name :
         {"layer.vtu", "layer.vtk", "layer.e", "layer.cgns", "layer.vtkhdf"}) {  // 50 ms each
        std::ifstream in(folder + "formats/" + name, std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        const std::string good = text.str();
        const auto broken = [&](const std::string& bytes) {
            const fs::path file = work / name;
            std::ofstream(file, std::ios::binary) << bytes;
            return message_of(file.string());
        };
        for (const std::string& bytes :
             {good.substr(0, good.size() / 2), std::string("\x1f\x8b\x08 gzip")}) {
            const std::string message = broken(bytes);
            EXPECT_NE(message, "accepted") << name << ' ' << bytes.size();
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        }
    }
    fs::remove_all(work);
    EXPECT_NE(message_of(folder + "formats/none.vtu").find("No such file"), std::string::npos);
}

TEST(VtkFiles, AnswersThatAreNotConsistentAreRefused) {
    MeshAnswer answer;
    MeshData mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}};
    mesh.types = {3};
    mesh.offsets = {0, 2};
    mesh.connectivity = {0, 1};
    mesh.point_arrays = {{"p", 1, {1, 2}, {}}};
    answer.meshes = {mesh};
    MeshAnswer again;
    ASSERT_TRUE(read_answer(written(answer), again));
    EXPECT_EQ(again.meshes[0].connectivity, mesh.connectivity);
    EXPECT_EQ(again.meshes[0].point_arrays[0].values, mesh.point_arrays[0].values);
    const std::string bytes = written(answer);
    for (std::size_t n = 0; n < bytes.size(); ++n)
        EXPECT_FALSE(read_answer(bytes.substr(0, n), again));
    answer.meshes[0].connectivity[1] = 2;
    EXPECT_FALSE(read_answer(written(answer), again));
}

}  // namespace
}  // namespace tricontact::benchmarks::vtk_file_test

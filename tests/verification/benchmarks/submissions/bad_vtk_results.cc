// Broken files of VTK's formats: each is one clear error, within its limits. A tenth of a second
// each.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/unit/benchmarks/submissions/bad_file.h"

namespace tricontact::benchmarks::bad_vtk_results_test {
namespace {

namespace fs = std::filesystem;

const std::string gzip("\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03\x4b\x4c\x4a", 13);
const std::string vtu_begin =
    "<?xml version=\"1.0\"?><VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
    "byte_order=\"LittleEndian\"><UnstructuredGrid><Piece NumberOfPoints=\"";

std::string vtu(const std::string& n_points, const std::string& n_cells, const std::string& rest) {
    return vtu_begin + n_points + "\" NumberOfCells=\"" + n_cells + "\">" + rest +
           "</Piece></UnstructuredGrid></VTKFile>";
}
const std::string square =
    "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 1 1 "
    "0 "
    "0 1 0</DataArray></Points><Cells><DataArray type=\"Int64\" Name=\"connectivity\" "
    "format=\"ascii\">0 1 2 NODE</DataArray><DataArray type=\"Int64\" Name=\"offsets\" "
    "format=\"ascii\">4</DataArray><DataArray type=\"UInt8\" Name=\"types\" "
    "format=\"ascii\">TYPE</DataArray></Cells><PointData><DataArray type=\"Float64\" Name=\"p\" "
    "format=\"ascii\">1 2 3 VALUE</DataArray></PointData>";
std::string square_with(const std::string& node, const std::string& type,
                        const std::string& value) {
    std::string text = square;
    text.replace(text.find("NODE"), 4, node);
    text.replace(text.find("TYPE"), 4, type);
    text.replace(text.find("VALUE"), 5, value);
    return vtu("4", "1", text);
}

std::vector<BadFile> bad_files() {
    const std::string vtk = "# vtk DataFile Version 3.0\na\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    return {
        {"square.vtu", square_with("3", "9", "4"), ""},
        {"huge_points.vtu", vtu("1000000000", "1", square), "write it again"},
        {"huge_cells.vtu", vtu("4", "4000000000", square), "write it again"},
        {"negative.vtu", vtu("-4", "1", square), "", true},  // VTK decides; no crash
        {"point_not_there.vtu", square_with("77", "9", "4"), "write it again"},
        {"unknown_cell.vtu", square_with("3", "42", "4"), "VTK type 42 are not read"},
        {"nan.vtu", square_with("3", "9", "nan"), "write it again"},
        {"cut.vtu", vtu_begin, "write it again"},
        {"html.vtu", "<!DOCTYPE html><html><body>404</body></html>", "write it again"},
        {"csv.vtu", "r,p\n0,1\n", "write it again"},
        {"gzip.vtu", gzip, "write it again"},
        {"entities.vtu",
         "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY a \"aaaaaaaaaaaaaaaa\"><!ENTITY b "
         "\"&a;&a;&a;&a;&a;&a;&a;&a;\">]><VTKFile type=\"&b;\"/>",
         "write it again"},
        {"huge_points.vtk", vtk + "POINTS 2000000000 double\n0 0 0\n", "write it again"},
        {"negative_points.vtk", vtk + "POINTS -5 double\n0 0 0\n", "write it again"},
        {"text.vtk", "hello\n", "write it again"},
        {"text.e", "hello\n", "write it again"},
        {"text.case", "hello\n", "write it again"},
        {"files_missing.case",
         "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: none.geo\nVARIABLE\nscalar per node: p "
         "a.p\n",
         "write it again"},
        {"text.cgns", "hello\n", "write it again"},
        {"text.vtkhdf", "hello\n", "write it again"},
        {"empty.pvd", "<VTKFile type=\"Collection\"><Collection/></VTKFile>", "names no files"},
        {"itself.pvd", "<DataSet timestep=\"0\" file=\"itself.pvd\"/>", "names a collection again"},
        {"missing.pvd", "<DataSet timestep=\"0\" file=\"none.vtu\"/>", "names a file that is not"},
        {"itself.pvtu",
         "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid><Piece Source=\"itself.pvtu\"/>"
         "</PUnstructuredGrid></VTKFile>",
         "write it again"},
    };
}

TEST(BadVtkResults, AreOneClearErrorEach) {
    const fs::path work =
        fs::temp_directory_path() / ("bad_vtk_results_" + std::to_string(getpid()));
    fs::create_directories(work);
    for (const BadFile& bad : bad_files()) expect_one_clear_error(work, bad);
    // Nothing else was written there.
    std::size_t n_files = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(work)) ++n_files;
    EXPECT_EQ(n_files, bad_files().size());
    fs::remove_all(work);
}

}  // namespace
}  // namespace tricontact::benchmarks::bad_vtk_results_test

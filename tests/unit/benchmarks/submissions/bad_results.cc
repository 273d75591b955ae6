// Files that users, editors and broken disks leave: each is one clear error, or read.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/submissions/read_field.h"
#include "contact/base/error.h"
#include "tests/unit/benchmarks/submissions/bad_file.h"

namespace tricontact::benchmarks::bad_results_test {
namespace {

namespace fs = std::filesystem;

const std::string gzip("\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03\x4b\x4c\x4a", 13);
std::vector<BadFile> bad_files() {
    const std::string frd = "    1C\n";
    return {
        {"empty.csv", "", "the table is empty"},
        {"comment.csv", "# nothing\n", "the table is empty"},
        {"binary.csv", std::string(5000, '\0'), "holds zero bytes"},
        {"gzip.csv", gzip, "holds zero bytes"},
        {"crlf.csv", "r [mm],p [MPa]\r\n0,1\r\n", ""},
        {"latin1.csv", "r [\xb5m],p [MPa]\n0,1\n", ""},
        {"decimal_commas.csv", "r [mm];p [MPa]\n0,5;1,5\n", ""},
        {"decimal_commas_too_many.csv", "r [mm],p [MPa]\n0,5,1,5\n",
         "divide columns by semicolons"},
        {"nan.csv", "r,p\n0,NaN\n", "must be a finite number"},
        {"infinite.csv", "r,p\n0,inf\n", "must be a finite number"},
        {"ragged.csv", "r,p\n0,1\n0\n", "has 1 columns instead of 2"},
        {"no_pressure.csv", "r,temperature\n0,1\n", "no pressure, traction, nodal force"},
        {"no_position.csv", "p,temperature\n0,1\n", "no column of positions"},
        {"words.csv", "this is no table\nat all\n", "has 2 columns instead of 4"},
        {"print.dat", "\n total force (fx,fy,fz) for set A and time  0.1\n\n 1 2 3\n",
         "holds resultants of CalculiX"},
        {"a.unknown", "r,p\n0,1\n", "unknown kind of file"},
        {"a.odb", "r,p\n0,1\n", "unknown kind of file"},
        {"empty.frd", "", "is no result file of CalculiX"},
        {"binary.frd", std::string(5000, '\xff'), "is no result file of CalculiX"},
        {"gzip.frd", gzip, "holds zero bytes"},
        {"cut.frd", frd + "    2C                           281             1\n -1    ",
         "a node needs its number"},
        {"huge_count.frd",
         frd + "    2C                    1000000000                                     1\n -3\n",
         "has no block of nodes"},
        {"huge_line.frd", frd + "    2C    1\n -1" + std::string(100'000, '1') + "\n",
         "the file ends within a block"},
        {"huge_material.frd",
         frd + "    2C    1                  1\n -1         1 0.00000E+00 0.00000E+00 0.00000E+00\n"
               " -3\n    3C    1\n -1         1    1    0    1\n -2         1\n -3\n",
         "an element of type 1 has 1 nodes"},
        {"no_elements.frd",
         frd + "    2C    1                  1\n -1         1 0.00000E+00 0.00000E+00 0.00000E+00\n"
               " -3\n 9999\n",
         "has no elements"},
        {"empty.rpt", "", "the table is empty"},
        {"cut.rpt",
         "Field Output reported at nodes for part: A\n\n Node  CPRESS\n-----------------"
         "-----------\n",
         "the report has no table"},
    };
}

TEST(BadResults, AreOneClearErrorEach) {
    const fs::path work = fs::temp_directory_path() / ("bad_results_" + std::to_string(getpid()));
    fs::create_directories(work);
    for (const BadFile& bad : bad_files()) expect_one_clear_error(work, bad);
    // Neither a folder nor a pipe is waited for.
    fs::create_directories(work / "folder.vtu");
    EXPECT_THROW(read_field({(work / "folder.vtu").string(), "", ""}), contact::InputError);
    EXPECT_THROW(read_field({(work / "none.frd").string(), "", ""}), contact::InputError);
    // Nothing else was written there.
    std::size_t n_files = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(work)) ++n_files;
    EXPECT_EQ(n_files, bad_files().size() + 1);
    fs::remove_all(work);
}

}  // namespace
}  // namespace tricontact::benchmarks::bad_results_test

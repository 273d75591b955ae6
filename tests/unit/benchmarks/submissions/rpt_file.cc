#include "benchmarks/submissions/rpt_file.h"

#include <gtest/gtest.h>

#include <string>

#include "benchmarks/submissions/read_field.h"
#include "contact/base/error.h"
#include "tests/paths.h"

namespace tricontact::benchmarks::rpt_file_test {
namespace {

const std::string report = paths::source("tests/benchmarks/formats/abaqus.rpt");

TEST(RptFile, ColumnsOfThePartInContactAreRead) {
    const MeshField field = read_field({report, "", report});
    EXPECT_EQ(field.format, "Abaqus report");
    EXPECT_EQ(field.find(Meaning::x)->values, (std::vector<double>{0, 1, 5.2}));
    EXPECT_EQ(field.find(Meaning::pressure)->values, (std::vector<double>{.421046, .401046, 0}));
    EXPECT_EQ(field.find(Meaning::displacement_y)->heading, "U.U2");
    EXPECT_EQ(field.totals.at("normal_force").value, -236.972);
    EXPECT_FALSE(field.find(Meaning::force_y)) << "reactions are no nodal forces of the contact";
}

std::string table(const std::string& part, const std::string& names, const std::string& rows) {
    return "Field Output reported at nodes for part: " + part + "\n\n" + names +
           "\n------------------------------\n" + rows + "\n\n";
}

TEST(RptFile, TheLastStateCounts) {
    const std::string names = "  Node  COORD.COOR1  CPRESS\n Label  @Loc 1  @Loc 1";
    const MeshField field = parse_rpt(table("A", names, "1 0. 5.\n2 1. 4.") +
                                          table("A", "Node  U.U3\nLabel  @Loc 1", "1 7.\n2 8.") +
                                          table("A", names, "1 0. 6.\n2 1. 5."),
                                      "a.rpt", "");
    EXPECT_EQ(field.find(Meaning::pressure)->values, (std::vector<double>{6, 5}));
    EXPECT_EQ(field.find(Meaning::displacement_z)->values, (std::vector<double>{7, 8}));
}

TEST(RptFile, SeveralPartsInContactNeedAName) {
    const std::string names = "Node  COORD.COOR1  CPRESS";
    const std::string both =
        table("A", names, "1 0. 5.\n2 1. 4.") + table("B", names, "1 0. 6.\n2 1. 4.");
    EXPECT_EQ(parse_rpt(both, "a.rpt", "B").find(Meaning::pressure)->values[0], 6);
    for (const char* set : {"", "C"})
        EXPECT_THROW(parse_rpt(both, "a.rpt", set), contact::InputError);
    EXPECT_THROW(parse_rpt(table("A", names, "1 0. 5.\n2 1."), "a.rpt", ""), contact::InputError);
    EXPECT_THROW(parse_rpt(table("A", "Node  CPRESS", "1 0. 5."), "a.rpt", ""),
                 contact::InputError);
    EXPECT_THROW(parse_rpt_totals(both, "a.rpt"), contact::InputError);
}

}  // namespace
}  // namespace tricontact::benchmarks::rpt_file_test

// A force or shift that alternates about zero: the path that [load] says.

#include <gtest/gtest.h>

#include "contact/rig_stiffness.h"
#include "io/case/case_reader.h"
#include "tests/unit/io/sphere_case.h"

namespace tricontact::io::oscillation_test {
namespace {

using contact::PrescribedPath;
using contact::TangentialControl;

contact::Case parsed(const std::string& lines) {
    return parse_case(pressed_sphere + lines, "case.toml");
}

TEST(Oscillation, OfAForceIsAQuarterAndClosedCycles) {
    const contact::Case c =
        parsed("tangential_amplitude = \"6 N\"\nperiods = 2\nsteps_per_quarter = 5\n");
    ASSERT_TRUE(c.prescribed_path);
    const auto& rows = c.prescribed_path->rows;
    const std::vector<double> expected{0, 6, -6, 6, -6, 6};
    ASSERT_EQ(rows.size(), expected.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        EXPECT_EQ(rows[r].tangential[0].kind, TangentialControl::Kind::force);
        EXPECT_EQ(rows[r].tangential[0].value, expected[r]);
        EXPECT_EQ(rows[r].normal.value, 21.1);
        if (r == 0) continue;
        EXPECT_EQ(rows[r].steps, r == 1 ? 5 : 10);
    }
}

TEST(Oscillation, OfAShiftIsOne) {
    const contact::Case c = parsed("shift_amplitude = \"25 um\"\n");
    const auto& rows = c.prescribed_path->rows;
    EXPECT_EQ(rows.back().tangential[0].kind, TangentialControl::Kind::shift);
    EXPECT_DOUBLE_EQ(rows.back().tangential[0].value, 25e-6);
}

TEST(Oscillation, IsWrittenAsItWasSaid) {
    const contact::Case c = parsed(
        "shift_amplitude = \"25 um\"\nperiods = 3\n[rig]\ntangential_stiffness = \"1e5 N/m\"\n");
    const std::string text = write_case(c);
    const contact::Case again = parse_case(text, "resolved.toml");
    EXPECT_EQ(write_case(again), text);
    ASSERT_TRUE(again.prescribed_path);
    EXPECT_EQ(again.prescribed_path->rows.size(), c.prescribed_path->rows.size());
    EXPECT_EQ(again.of<contact::RigStiffness>().tangential, 1e5);
    EXPECT_EQ(text.find("tangential_ratio"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::io::oscillation_test

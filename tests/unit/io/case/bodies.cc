// Shapes of the indenter in case files, and the table of a profile.

#include <gtest/gtest.h>

#include <string>

#include "contact/base/error.h"
#include "io/case/case_reader.h"
#include "io/tables/body_tables.h"
#include "tests/paths.h"
#include "tests/unit/io/temporary_folder.h"

namespace tricontact::io::bodies_test {
namespace {

using contact::Case;

std::string text_of(const std::string& indenter) {
    return "models = [\"bem\"]\n[indenter]\n" + indenter +
           "\n[substrate]\nyoung = \"5.2 MPa\"\npoisson = 0.5\n[friction]\ncoefficient = 0.5\n"
           "[load]\nnormal_force = \"20 N\"\ntangential_ratio = 0.3\n";
}

TEST(IoBodies, ComeBackFromAResolvedCase) {
    const std::string table = paths::source("examples/cases/body_profile.csv");
    for (const std::string& indenter :
         {std::string("shape = \"cone\"\nangle = \"7 deg\""),
          std::string("shape = \"power-law\"\nradius = \"40 mm\"\nexponent = 3.5"),
          std::string("shape = \"rounded-punch\"\nradius = \"40 mm\"\nflat_radius = \"3 mm\""),
          std::string("shape = \"ellipsoid\"\nradius = \"40 mm\"\nradius_y = \"0.1 m\""),
          "shape = \"profile\"\nfile = \"" + table + '"'}) {
        const Case c = parse_case(text_of(indenter), "case.toml");
        const Case again = parse_case(write_case(c), "again.toml");
        EXPECT_EQ(again.indenter.shape, c.indenter.shape) << indenter;
        EXPECT_EQ(again.indenter.radius, c.indenter.radius);
        EXPECT_EQ(again.indenter.radius_y, c.indenter.radius_y);
        EXPECT_EQ(again.indenter.angle, c.indenter.angle);
        EXPECT_EQ(again.indenter.exponent, c.indenter.exponent);
        EXPECT_EQ(again.indenter.flat_radius, c.indenter.flat_radius);
        EXPECT_EQ(again.indenter.profile.size(), c.indenter.profile.size());
        EXPECT_EQ(again.make_indenter()->height(.004, .003), c.make_indenter()->height(.004, .003));
    }
}

auto parse_profile_table(const std::string& text, const std::string& name) {
    return read_text(text, name, read_profile_table);
}

TEST(IoBodies, ProfileTablesHaveUnitsAndKinks) {
    const auto points =
        parse_profile_table("h [um]; r [mm]; kink\n0;0;1\n5;1;0\n9;2.5;1\n", "t.csv");
    ASSERT_EQ(points.size(), 3U);
    EXPECT_TRUE(points[0].kink);
    EXPECT_EQ(points[1].radius, 1e-3);
    EXPECT_EQ(points[1].height, 5e-6);
    EXPECT_FALSE(points[1].kink);
    EXPECT_FALSE(parse_profile_table("r [mm],h [um]\n0,0\n1,1\n", "t.csv")[1].kink);
}

TEST(IoBodies, ProfileTablesAreRefusedByRow) {
    const auto message = [](const std::string& text) -> std::string {
        try {
            parse_profile_table(text, "t.csv");
        } catch (const contact::InputError& error) {
            return error.what();
        }
        return "(accepted)";
    };
    const auto expect = [&](const std::string& text, const std::string& part) {
        EXPECT_NE(message(text).find(part), std::string::npos) << message(text);
    };
    expect("r [mm],h [um]\n0,0\n", "t.csv:1: fewer than two rows");
    expect("r [mm]\n0\n1\n", "the column h is missing");
    expect("r [mm],h [um],w [m]\n0,0,0\n1,1,1\n", "unknown column \"w\"; known are r, h, kink");
    expect("r [mm],h [um],kink\n0,0,0\n1,1,2\n", "t.csv:3: kink = 2: must be 0 or 1");
    expect("r [mm],h [um]\n0,1\n1,2\n", "t.csv:2: h = 1: heights count from");
    expect("r [mm],h [um]\n0,0\n1,2\n1,3\n", "t.csv:4: r = 1: radii must increase");
    expect("r [mm],h [um]\n0,0\n1,0\n2,0\n", "t.csv:4: h = 0: the profile is flat");
    expect("r [N],h [um]\n0,0\n1,1\n", "t.csv:1");
}

}  // namespace
}  // namespace tricontact::io::bodies_test

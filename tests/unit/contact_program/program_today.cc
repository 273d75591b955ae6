// Files of CONTACT as its users have them: values that no case says cost their own case alone, what
// is kept and what is about another point is read as CONTACT does.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact_program/import.h"
#include "contact_program/program_case.h"
#include "contact_program/sequence.h"
#include "io/case/case_reader.h"

namespace tricontact::contact_program::program_today_test {
namespace {

using contact::Case;
using contact::CentreOfRotation;
using contact::TangentialControl;

/// Two steel balls: digits of the first two words, loads, what follows FSTAT and FKIN and what
/// comes after the materials, the body, and what follows it.
struct Ball {
    std::string pressing = "200100", variant = "0022020", loads = "1000 0 0 0",
                friction = "0.3 0.3", rolling, materials, body = ".001 0 .001 0 0 0", last;

    std::string text() const {
        const auto line = [](const std::string& values) {
            return values.empty() ? "" : " " + values + "\n";
        };
        return " 3 MODULE\n" + line(pressing) + line(variant) + " 0000111\n 100 100 30 1 1e-6\n" +
               line(loads) + line(friction) + line(rolling) + " 0.28 0.28 82000 82000\n" +
               line(materials) + " 1\n 5 5 -.5 -.5 .2 .2\n 1 1\n" + line(body) + line(last);
    }
};

Import imported(const std::string& text) {
    return import_cases(text + " 0 MODULE\n", "file.inp", bem::is_coupled);
}

Case only_case(const std::string& text) {
    const Import found = imported(text);
    EXPECT_EQ(found.cases.size(), 1U);
    EXPECT_TRUE(found.left_out.empty());
    return io::parse_case(found.cases.at(0).text, "case.toml");
}

TEST(ProgramToday, UnknownValuesCostTheirOwnCaseAlone) {
    const Ball good;
    const std::string rolls = "203100", driven = "1000 -0.002 0 0", way = "0 .2 1000";
    const std::vector<std::pair<Ball, std::string>> odd{
        {{.variant = "3022020", .friction = "", .last = ".2 .2\n .2 .2\n .2 .2\n .2 .2\n .2 .2"},
         "V = 3"},
        {{.pressing = "300100"}, "P = 3"},
        {{.variant = "0022022"}, "E = 2"},
        {{.pressing = rolls,
          .variant = "0022520",
          .loads = driven,
          .rolling = way,
          .materials = "0.3 1 0"},
         "M = 5"},
        {{.pressing = rolls, .variant = "0022620", .loads = driven, .rolling = way}, "M = 6"}};
    for (const auto& [ball, digit] : odd) {
        SCOPED_TRACE(digit);
        const Import found = imported(good.text() + ball.text() + good.text());
        EXPECT_EQ(found.cases.size(), 2U);
        ASSERT_EQ(found.left_out.size(), 1U);
        EXPECT_EQ(found.left_out[0].first, 2U);
        EXPECT_NE(found.left_out[0].reason.find(digit), std::string::npos)
            << found.left_out[0].reason;
    }
}

// D = 2 with Z = 1: the same body over other cells.
TEST(ProgramToday, KeepsTheBodyOverNewCells) {
    const std::string finer =
        " 3 MODULE\n 200100\n 0122010\n 0100111\n 1000 0 0 0\n .28 .28 82000 82000\n 1\n"
        " 9 9 -.45 -.45 .1 .1\n";
    const Import found = imported(Ball{}.text() + finer);
    ASSERT_EQ(found.cases.size(), 2U);
    const Case coarse = io::parse_case(found.cases[0].text, "a.toml"),
               fine = io::parse_case(found.cases[1].text, "b.toml");
    EXPECT_DOUBLE_EQ(*coarse.of<contact::Cells>().spacing, 2e-4);
    EXPECT_DOUBLE_EQ(*fine.of<contact::Cells>().spacing, 1e-4);
    EXPECT_DOUBLE_EQ(fine.indenter.radius, .5);
    EXPECT_EQ(coarse.indenter.radius, fine.indenter.radius);
    // Heights by a formula are those of the new cells, listed ones are not known there.
    const auto waves = [&](const std::string& ibase, const std::string& data) {
        std::string text = Ball{.body = data}.text();
        text.replace(text.rfind(" 1 1\n"), 5, " " + ibase + " 1\n");
        return read_program_cases(text + finer + " 0 MODULE\n", "file.inp");
    };
    const auto cases = waves("3", "0 1 0 0 1 0 500 500");
    ASSERT_EQ(cases[1].distance.heights->size(), 81U);
    EXPECT_NEAR((*cases[1].distance.heights)[0], 2 * .4e-3 * .4e-3 / .5, 1e-12);
    EXPECT_THROW(waves("9", "0 0 0 0 0\n 0 0 0 0 0\n 0 0 0 0 0\n 0 0 0 0 0\n 0 0 0 0 0"),
                 contact::InputError);
}

TEST(ProgramToday, PressesWithoutFriction) {
    const Case pressed = only_case(Ball{.friction = "0 0"}.text());
    EXPECT_EQ(*pressed.load.normal_force, 1000);
    EXPECT_THROW(imported(Ball{.pressing = "201120", .friction = "0 0"}.text()),
                 contact::InputError);
}

// A depth is that of a force on the case's own cells, which are coarse here.
TEST(ProgramToday, DepthsAreThoseOfTheCells) {
    const std::string then = " 3 MODULE\n 001000\n 0100000\n 0100111\n 0.0123 0.001 0 0\n";
    const auto read = [&](double depth) {
        return import_cases(Ball{}.text() + then + " 0 MODULE\n", "file.inp", bem::is_coupled,
                            [=](const Case&) { return depth; });
    };
    EXPECT_EQ(read(1.23e-5).cases.size(), 1U);
    EXPECT_THROW(read(1.25e-5), contact::InputError);
}

// A twist is no detail of a loaded contact, nor of one that rolls back and forth.
TEST(ProgramToday, TwistsAreKept) {
    const Case twisted =
        only_case(Ball{.pressing = "201120", .loads = "1000 -0.5 0 0.001 0.3 -0.2"}.text());
    ASSERT_TRUE(twisted.prescribed_path);
    const auto& path = *twisted.prescribed_path;
    EXPECT_EQ(path.rows.back().rotation, .001);
    EXPECT_EQ(path.centre.frame, CentreOfRotation::Frame::substrate);
    EXPECT_NEAR(path.centre.place[0], 3e-4, 1e-15);
    EXPECT_NEAR(path.centre.place[1], -2e-4, 1e-15);
    // Of the origin there, from the cell under the body's lowest point (0.2, 0) here.
    const Case aside = only_case(Ball{
        .pressing = "201100", .loads = "1000 0.001 0 0.001", .body = ".001 0 .001 -.0004 0 .00004"}
                                     .text());
    EXPECT_NEAR(aside.prescribed_path->centre.place[0], -2e-4, 1e-12);
    EXPECT_EQ(aside.prescribed_path->rows.back().offset[0], 0);
    EXPECT_NEAR(aside.prescribed_path->rows.back().tangential[0].value, 1e-6, 1e-18);
    // Held along y: a twist about a point beside the body pushes it there.
    EXPECT_EQ(aside.prescribed_path->rows.back().tangential[1].kind,
              TangentialControl::Kind::shift);
}

// Of two points that cases twist about the shift of one is that of the other and the twist.
TEST(ProgramToday, TwistsAboutTwoPointsAreOnePath) {
    const Case c = only_case(Ball{.pressing = "201100", .loads = "1000 0 0 0.001"}.text() +
                             " 3 MODULE\n 001100\n 0100000\n 0100111\n 1000 0.002 0 0.003 1 2\n");
    const auto& row = c.prescribed_path->rows.back();
    EXPECT_NEAR(row.rotation, .004, 1e-15);
    EXPECT_NEAR(row.tangential[0].value, 2e-6 + .003 * 2e-3, 1e-15);
    EXPECT_NEAR(row.tangential[1].value, -.003 * 1e-3, 1e-15);
}

// Creepages are about the body's lowest point here, about (SPINXO, SPINYO) there; a contact that
// rolls towards -x is turned round after that.
TEST(ProgramToday, SpinIsAboutTheLowestPoint) {
    for (const bool back : {false, true}) {
        const Case c = only_case(Ball{.pressing = "203100",
                                      .loads = "1000 -0.002 0.001 0.0004 0.1 0.3",
                                      .rolling = back ? "180d .2 1000" : "0 .2 1000",
                                      .body = ".001 0 .001 -.0008 .0004 .0002"}
                                     .text());
        // From (0.1, 0.3) to the lowest point (0.4, -0.2) mm.
        const double sign = back ? -1 : 1;
        EXPECT_NEAR(*c.tractive_rolling->longitudinal_creepage, sign * (-.002 + .0004 * .5), 1e-15);
        EXPECT_NEAR(*c.tractive_rolling->lateral_creepage, sign * (.001 + .0004 * .3), 1e-15);
        EXPECT_DOUBLE_EQ(c.tractive_rolling->spin, .4);
    }
}

// The cells of what rolls on are those of the file about the body's lowest point: DX x DY, wherever
// 0 lies between them; a contact that rolls towards -x is turned round with them.
TEST(ProgramToday, RollingKeepsTheCells) {
    for (const bool back : {false, true}) {
        Ball ball{.pressing = "203100",
                  .loads = "1000 -0.002 0 0",
                  .rolling = back ? "180d .2 1000" : "0 .2 1000",
                  .body = ".001 0 .001 -.00026 .0003 0"};
        std::string text = ball.text();
        text.replace(text.find("5 5 -.5 -.5 .2 .2"), 17, "5 9 -.5 -2.25 .2 .5");
        const Case c = only_case(text);
        // Centres at -0.4 + 0.2 i and -2 + 0.5 j mm, the lowest point at (0.13, -0.15) mm.
        const double sign = back ? -1 : 1;
        EXPECT_NEAR(*c.of<contact::Cells>().spacing, 2e-4, 1e-15);
        EXPECT_NEAR(*c.of<contact::Cells>().ratio, 2.5, 1e-12);
        EXPECT_NEAR(*c.of<contact::Cells>().shift_x, sign * .07 / .2, 1e-9);
        EXPECT_NEAR(*c.of<contact::Cells>().shift_y, sign * .15 / .5, 1e-9);
        const auto compliance = bem::case_compliance(c, 1, bem::Body::half_space);
        const auto& grid = compliance->points();
        for (const int axis : {0, 1}) {
            const double h = axis == 0 ? 2e-4 : 5e-4;
            EXPECT_NEAR(grid.spacing[axis] / h, 1, 1e-12);
            const double cells = (grid.first[axis] - sign * (axis == 0 ? 7e-5 : 1.5e-4)) / h;
            EXPECT_NEAR(cells, std::round(cells), 1e-6);
        }
    }
}

TEST(ProgramToday, TitlesNameTheFileAlone) {
    const auto found =
        import_cases(Ball{}.text() + " 0 MODULE\n", "/home/me/secret/file.inp", bem::is_coupled);
    EXPECT_EQ(found.cases[0].text.find("secret"), std::string::npos);
}

// What rolls on is pressed, rolled from rest and steady: two cases, the numbers of the one.
TEST(ProgramToday, RollingOnComesBack) {
    const std::string text =
        "models = [\"bem\"]\n[indenter]\nradius = \"40 mm\"\nyoung = \"210 GPa\"\npoisson = 0.28\n"
        "[substrate]\nyoung = \"210 GPa\"\npoisson = 0.28\n[friction]\ncoefficient = 0.3\n"
        "[load]\nnormal_force = \"100 N\"\n[bem]\ncells_per_radius = 5\n[tractive_rolling]\n"
        "distance = 2\n";
    for (const auto& [drive, cells] : std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"longitudinal_creepage = 0.0002\n", {}},
             {"longitudinal_creepage = 0.0002\nlateral_creepage = 0.0001\nspin = \"0.3 rad/m\"\n",
              {}},
             {"longitudinal_creepage = 0.0002\n",
              {"bem.cell_ratio=2", "bem.cell_shift_x=0.5", "bem.cell_shift_y=-0.3"}}}) {
        const Case c = io::parse_case(text + drive, "roll.toml", cells);
        const auto compliance = bem::case_compliance(c, 1, bem::Body::half_space);
        const Import found =
            imported(sequence_text(c, compliance->points(), compliance->is_coupled(), {}));
        ASSERT_EQ(found.cases.size(), 2U);
        EXPECT_TRUE(found.left_out.empty());
        EXPECT_EQ(found.cases[0].n_steps(), 11U);  // pressed, and ten cells in two half lengths
        for (const ImportedCase& one : found.cases) {
            const Case back = io::parse_case(one.text, "back.toml");
            const auto &given = *c.tractive_rolling, &read = *back.tractive_rolling;
            EXPECT_NEAR(*read.longitudinal_creepage, *given.longitudinal_creepage, 1e-15);
            EXPECT_NEAR(read.lateral_creepage.value_or(0), given.lateral_creepage.value_or(0),
                        1e-15);
            EXPECT_NEAR(read.spin, given.spin, 1e-12);
            EXPECT_NEAR(*back.of<contact::Cells>().spacing / compliance->points().spacing[0], 1,
                        1e-12);
            EXPECT_NEAR(back.of<contact::Cells>().ratio.value_or(1),
                        c.of<contact::Cells>().ratio.value_or(1), 1e-12);
            EXPECT_NEAR(std::abs(back.of<contact::Cells>().shift_x.value_or(0)),
                        std::abs(c.of<contact::Cells>().shift_x.value_or(0)), 1e-9);
            EXPECT_NEAR(back.of<contact::Cells>().shift_y.value_or(0),
                        c.of<contact::Cells>().shift_y.value_or(0), 1e-9);
        }
    }
}

}  // namespace
}  // namespace tricontact::contact_program::program_today_test

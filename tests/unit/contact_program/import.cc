// What cases of CONTACT become: case files of each kind, and what export writes.

#include "contact_program/import.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact_program/input_lines.h"
#include "contact_program/program_case.h"
#include "contact_program/sequence.h"
#include "contact_program/written_case.h"
#include "io/case/case_reader.h"
#include "tests/unit/io/sphere_case.h"

namespace tricontact::contact_program::import_test {
namespace {

using contact::Case;

/// A case of two steel balls; `loads`: FN and three tangential values, `rolling`: CHI, DQ, VELOC.
std::string program_case(const std::string& digits, const std::string& loads,
                         const std::string& rolling = "") {
    return " 3 MODULE\n " + digits + "\n 022020\n 0000111\n 100 100 30 1 1e-6\n " + loads +
           "\n 0.3 0.3\n " + rolling + (rolling.empty() ? "" : "\n ") +
           "0.28 0.28 82000 82000\n 1\n 41 41 -4.1 -4.1 .2 .2\n 1 1\n .001 0 .001 0 0 0\n";
}

/// One that keeps all but its loads.
std::string next_case(const std::string& digits, const std::string& loads) {
    return " 3 MODULE\n " + digits + "\n 100000\n 0100111\n " + loads + "\n";
}

/// Rolls on by its creepage at 2 m/s.
const std::string pressed_sphere_on_steel =
    "models = [\"bem\"]\n[indenter]\nradius = \"40 mm\"\nyoung = \"210 GPa\"\npoisson = 0.28\n"
    "[substrate]\nyoung = \"210 GPa\"\npoisson = 0.28\n[load]\nnormal_force = \"100 N\"\n"
    "[bem]\ncells_per_radius = 5\n[tractive_rolling]\nlongitudinal_creepage = 0.001\n"
    "speed = \"2 m/s\"\n[friction]\ncoefficient = 0.3\n";

std::vector<Case> cases_of(const std::string& text) {
    std::vector<Case> cases;
    for (const ImportedCase& one :
         import_cases(text + " 0 MODULE\n", "file.inp", bem::is_coupled).cases)
        cases.push_back(io::parse_case(one.text, "case.toml"));
    return cases;
}

TEST(ImportedCases, FortranNumbers) {
    InputLines lines(" .1-06 1.5d-3 +2E2 -3 -.5+1 7\n 180.0d 2.5 'a name, with = and blanks' x\n",
                     "numbers.inp");
    const auto v = lines.numbers(5, "numbers", 1);
    const double expected[] = {1e-7, 1.5e-3, 200, -3, -5, 7};
    ASSERT_EQ(v.size(), std::size(expected));
    for (std::size_t k = 0; k < v.size(); ++k) EXPECT_DOUBLE_EQ(v[k], expected[k]);
    EXPECT_DOUBLE_EQ(lines.angle_and_numbers(2, "an angle")[0], std::numbers::pi);
    InputLines named("'a name, with = and blanks' x\n", "numbers.inp");
    EXPECT_EQ(named.text("a name"), "a name, with = and blanks");
}

// A contact that rolls towards -x is seen from the other side: creepages and forces along x and y
// change their sign, spin does not; forces act on the other body.
TEST(ImportedCases, SteadyRolling) {
    const auto cases = cases_of(program_case("203100", "1000 -0.002 0.001 0.0002", "0 .2 1000") +
                                program_case("203100", "1000 -0.002 0.001 0.0002", "180d .2 1000") +
                                program_case("203120", "1000 0.4 0 0", "0 .2 1000"));
    ASSERT_EQ(cases.size(), 3U);
    EXPECT_EQ(*cases[0].tractive_rolling->longitudinal_creepage, -.002);
    EXPECT_EQ(*cases[0].tractive_rolling->lateral_creepage, .001);
    EXPECT_DOUBLE_EQ(cases[0].tractive_rolling->spin, .2);  // 2e-4 in 1 mm
    EXPECT_EQ(*cases[1].tractive_rolling->longitudinal_creepage, .002);
    EXPECT_EQ(*cases[1].tractive_rolling->lateral_creepage, -.001);
    EXPECT_DOUBLE_EQ(cases[1].tractive_rolling->spin, .2);
    EXPECT_EQ(*cases[2].load.tangential_ratio, -.4);
    EXPECT_DOUBLE_EQ(*cases[2].of<contact::Cells>().spacing, 2e-4);
}

/// Constants of a law L, then MEMDST and MEM_S0.
std::string falling_case(const std::string& law, const std::string& constants) {
    std::string text = program_case("203100", "1000 -0.002 0 0", "0 .2 30000");
    text.replace(text.find("022020"), 6, law + "22020");
    text.replace(text.find("0.3 0.3"), 7, constants);
    return text;
}

// FKIN is what is left of mu; a part of the size 0 is left out but for the first of the rational
// law, whose second has another form.
TEST(ImportedCases, FrictionThatFallsWithTheSlip) {
    using Law = contact::FrictionRate::Law;
    const auto cases = cases_of(falling_case("2", "0.2 0 0 0.15 50\n 0 1") +
                                falling_case("3", "0.2 0 0 0.1 300\n 0.004 2") +
                                falling_case("4", "0.2 0.05 100 0.1 300\n 0 0") +
                                falling_case("4", "0.2 0 0 0 0\n 0.004 2"));
    ASSERT_EQ(cases.size(), 4U);
    const auto &linear = cases[0].friction, &rational = cases[1].friction;
    EXPECT_DOUBLE_EQ(*linear.coefficient, .35);
    EXPECT_EQ(linear.rate->law, Law::linear);
    EXPECT_EQ(linear.rate->drops, std::vector{.15});
    EXPECT_DOUBLE_EQ(linear.rate->speeds.at(0), .05);
    EXPECT_EQ(linear.rate->memory_length, 0);
    EXPECT_DOUBLE_EQ(cases[0].tractive_rolling->speed, 30);
    EXPECT_EQ(rational.rate->law, Law::rational);
    EXPECT_EQ(rational.rate->drops, (std::vector{0, .1}));
    EXPECT_DOUBLE_EQ(rational.rate->coefficient(*rational.coefficient, .3), .25);
    EXPECT_DOUBLE_EQ(rational.rate->memory_length, 4e-6);
    EXPECT_DOUBLE_EQ(rational.rate->memory_speed, 2e-3);
    EXPECT_EQ(cases[2].friction.rate->law, Law::exponential);
    EXPECT_DOUBLE_EQ(*cases[2].friction.coefficient, .35);
    EXPECT_DOUBLE_EQ(cases[2].friction.rate->speeds.at(1), .3);
    EXPECT_TRUE(cases[3].friction.is_coulomb());
    EXPECT_THROW(cases_of(falling_case("4", "0.2 -0.1 100 0 0\n 0 0")), contact::InputError);
}

TEST(ImportedCases, WrittenFallingFrictionComesBack) {
    const Case c = io::parse_case(pressed_sphere_on_steel + R"([friction.rate]
law = "rational"
drops = [0.02, 0.1]
speeds = ["20 mm/s", "100 mm/s"]
memory_length = "3 um"
memory_speed = "1 mm/s"
)",
                                  "falling.toml");
    const auto compliance = bem::case_compliance(c, 1, bem::Body::half_space);
    const auto back =
        cases_of(sequence_text(c, compliance->points(), compliance->is_coupled(), {}));
    ASSERT_EQ(back.size(), 1U);
    const auto &rate = *c.friction.rate, &read = *back[0].friction.rate;
    EXPECT_DOUBLE_EQ(*back[0].friction.coefficient, .3);
    EXPECT_EQ(read.law, rate.law);
    EXPECT_EQ(read.drops, rate.drops);
    for (const std::size_t k : {0, 1}) EXPECT_DOUBLE_EQ(read.speeds[k], rate.speeds[k]);
    EXPECT_DOUBLE_EQ(read.memory_length, 3e-6);
    EXPECT_DOUBLE_EQ(read.memory_speed, 1e-3);
    EXPECT_DOUBLE_EQ(back[0].tractive_rolling->speed, 2);
    EXPECT_EQ(*back[0].tractive_rolling->longitudinal_creepage, 1e-3);
}

TEST(ImportedCases, RollingFromRest) {
    std::string text = program_case("201110", "1000 -0.5 0 0");
    text +=
        " 3 MODULE\n 002110\n 102000\n 0100111\n 1000 -0.5 0 0\n 0 .2 1000\n .28 .28 82000 82000\n";
    for (int k = 0; k < 4; ++k) text += next_case("002110", "1000 -0.5 0 0");
    const auto cases = cases_of(text);
    ASSERT_EQ(cases.size(), 1U);
    const double a = contact::half_space_scales(cases[0]).contact_radius;
    EXPECT_NEAR(cases[0].tractive_rolling->distance * a / 2e-4, 5, 1e-9);  // cells
    EXPECT_EQ(*cases[0].load.tangential_ratio, .5);
    EXPECT_THROW(cases_of(text + next_case("002110", "1000 -0.4 0 0")), contact::InputError);
}

// Shifts add up; forces are on the other body; both signs, unequal steps.
TEST(ImportedCases, PathsRowByRow) {
    const auto shifted = cases_of(program_case("201100", "500 0 0 0") +
                                  next_case("001100", "1000 0.001 -0.002 0.01") +
                                  next_case("001100", "900 0.004 0 0"));
    ASSERT_EQ(shifted.size(), 1U);
    ASSERT_TRUE(shifted[0].prescribed_path);
    const auto& rows = shifted[0].prescribed_path->rows;
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0].normal.value, 0);
    EXPECT_EQ(rows[3].normal.value, 900);
    EXPECT_NEAR(rows[2].tangential[0].value, 1e-6, 1e-18);
    EXPECT_NEAR(rows[3].tangential[0].value, 5e-6, 1e-18);
    EXPECT_NEAR(rows[3].tangential[1].value, -2e-6, 1e-18);
    EXPECT_NEAR(rows[3].rotation, .01, 1e-15);
    EXPECT_EQ(shifted[0].prescribed_path->n_steps(), 3);

    const auto forced =
        cases_of(program_case("201120", "1000 0.5 0 0") + next_case("001120", "1000 -0.5 0.25 0"));
    const auto& loads = forced.at(0).prescribed_path->rows;
    EXPECT_DOUBLE_EQ(loads[1].tangential[0].value, -150);  // mu F_N = 300 N
    EXPECT_DOUBLE_EQ(loads[2].tangential[0].value, 150);
    EXPECT_DOUBLE_EQ(loads[2].tangential[1].value, -75);
}

TEST(ImportedCases, SequencesOfTheirOwnAndWhatIsLeftOut) {
    const Import found = import_cases(program_case("200100", "1000 0 0 0") +
                                          program_case("203100", "1000 -0.002 0 0", "1 .2 1000") +
                                          program_case("201120", "1000 -0.5 0 0") + " 0 MODULE\n",
                                      "file.inp", bem::is_coupled);
    ASSERT_EQ(found.cases.size(), 2U);
    EXPECT_EQ(found.cases[1].first, 3U);
    ASSERT_EQ(found.left_out.size(), 1U);
    EXPECT_EQ(found.left_out[0].first, 2U);
    EXPECT_NE(found.left_out[0].reason.find("file.inp:20:1: CHI = 1: "), std::string::npos)
        << found.left_out[0].reason;
}

// CONTACT prints A1, B1 for its example fastsim, semi-axes and B1 for tractcurv.
TEST(ImportedCases, HertzianCells) {
    const auto read = [](const std::string& loads, const std::string& cells) {
        return read_program_cases(" 3 MODULE\n 200100\n 022020\n 0000111\n 100 100 30 1 1e-6\n " +
                                      loads + "\n .3 .3\n .28 .28 82000 82000\n " + cells +
                                      "\n 0 MODULE\n",
                                  "hertz.inp")
            .front();
    };
    const auto axes = read("82000 0 0 0", "-3\n 44 44 8 4 1.1");
    EXPECT_NEAR(axes.distance.curvature[0] / .8464, 1, 1e-4);  // [1/m]
    EXPECT_NEAR(axes.distance.curvature[1] / 2.406, 1, 2e-4);
    EXPECT_NEAR(axes.spacing[0], .4e-3, 1e-15);
    EXPECT_NEAR(axes.spacing[1], .2e-3, 1e-15);
    const auto ratio = read("106700 0 0 0", "-2\n 48 44 0.0008 0.5 1.1");
    EXPECT_NEAR(ratio.distance.curvature[1] / .2814, 1, 2e-4);
    EXPECT_NEAR(ratio.spacing[0] / .2889e-3, 1, 1e-4);
    EXPECT_NEAR(ratio.spacing[1] / .6304e-3, 1, 1e-4);
    const auto both = read("106700 0 0 0", "-1\n 48 44 0.0008 0.0002814 1.1");
    EXPECT_NEAR(both.spacing[1] / .6304e-3, 1, 2e-4);
    // A line of 200 mm: carter2d's contact is 1 mm wide to either side.
    const auto line = read("35780 0 0 0", "-4\n 50 1 0.001 100 1");
    EXPECT_NEAR(line.spacing[0] / .04e-3, 1, 1e-4);
}

TEST(ImportedCases, WrittenCaseIsTheCaseUnlessTheFileWasChanged) {
    const std::string input = " 3 MODULE\n 0 MODULE\n", text = "models = [\"bem\"]\n\n[load]\n";
    const std::string file = with_written_case(input, text);
    EXPECT_TRUE(file.starts_with(input));
    EXPECT_EQ(written_case(file), text);
    EXPECT_FALSE(written_case(input));
    EXPECT_FALSE(written_case("%" + file));
    EXPECT_FALSE(written_case(file + "more\n"));
}

// Whatever case is drawn, its numbers alone bring back its steps.
RC_GTEST_PROP(ImportedCases, WhatIsExportedComesBack, ()) {
    const auto percent = [](int low, int high) { return *rc::gen::inRange(low, high) / 100.; };
    const auto set = [](const char* key, const char* unit, double value) {
        return std::string(key) + "=" + std::to_string(value) + unit;
    };
    const auto count = [](const char* key, int value) {
        return std::string(key) + "=" + std::to_string(value);
    };
    std::vector<std::string> overrides{set("load.tangential_ratio", "", percent(0, 90)),
                                       set("substrate.poisson", "", percent(0, 50)),
                                       count("load.press_steps", *rc::gen::inRange(1, 6)),
                                       set("rolling.amplitude", " mm", percent(1, 200)),
                                       set("rolling.angle", " deg", *rc::gen::inRange(-180, 180)),
                                       count("rolling.steps_per_quarter", *rc::gen::inRange(1, 5)),
                                       count("rolling.periods", *rc::gen::inRange(1, 4)),
                                       set("indenter.radius", " mm", percent(1000, 9000)),
                                       set("load.normal_force", " N", percent(100, 5000))};
    if (*rc::gen::arbitrary<bool>())
        overrides.insert(overrides.end(), {set("indenter.young", " MPa", percent(100, 9000)),
                                           set("indenter.poisson", "", percent(0, 50))});
    const std::string text = io::loaded_sphere +
                             "[rolling]\namplitude = \"1 mm\"\nperiods = 1\n"
                             "run_all = true\n[bem]\ncells_per_radius = 5\n";
    const Case c = io::parse_case(text, "drawn.toml", overrides);
    const auto compliance = bem::case_compliance(c, 1, bem::Body::half_space);
    const bool coupled = compliance->is_coupled();
    const Import found = import_cases(sequence_text(c, compliance->points(), coupled, {}),
                                      "drawn.inp", bem::is_coupled);
    RC_ASSERT(found.cases.size() == 1U && found.left_out.empty());
    const Case back = io::parse_case(found.cases[0].text, "back.toml");
    if (!back.prescribed_path) {
        const auto a = sequence_of(c, coupled), b = sequence_of(back, coupled);
        RC_ASSERT(a.size() == b.size());
        const double h = compliance->points().spacing[0];
        for (std::size_t k = 0; k < a.size(); ++k) {
            RC_ASSERT(std::abs(a[k].normal.value / b[k].normal.value - 1) < 1e-9);
            RC_ASSERT(std::abs(a[k].along[0].value - b[k].along[0].value) < 1e-9);
            RC_ASSERT(std::hypot(a[k].offset[0] - b[k].offset[0], a[k].offset[1] - b[k].offset[1]) <
                      1e-9 * h);
        }
    } else {
        RC_FAIL("a case of periods came back as a path");
    }
}

}  // namespace
}  // namespace tricontact::contact_program::import_test

// Prescribed paths as cases of CONTACT: what is written, read from the numbers alone, and both
// again.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "contact/base/error.h"
#include "contact_program/import.h"
#include "contact_program/sequence.h"
#include "io/case/case_reader.h"

namespace tricontact::contact_program::contact_path_test {
namespace {

using contact::Case;
using contact::Vector2;

std::string path_text(const std::string& table, const std::string& keys = "") {
    return "models = [\"bem\"]\n[indenter]\nradius = \"40 mm\"\n[substrate]\nyoung = \"5.2 MPa\"\n"
           "poisson = 0.5\n[friction]\ncoefficient = 0.5\n[bem]\ncells_per_radius = 5\n[path]\n"
           "steps = 0\n" +
           keys + "table = \"\"\"\n" + table + "\"\"\"\n";
}

struct Written {
    Case c;
    bool coupled;
    double cell;
    std::string text;
};

Written written(const std::string& text, const std::vector<std::string>& overrides = {}) {
    Written out{io::parse_case(text, "path.toml", overrides), false, 0, {}};
    const auto compliance = bem::case_compliance(out.c, 1, bem::Body::half_space);
    out.coupled = compliance->is_coupled();
    out.cell = compliance->points().spacing[0];
    out.text = sequence_text(out.c, compliance->points(), out.coupled, {});
    return out;
}

/// The values of all lines that end with this comment.
std::vector<std::vector<double>> values_of(const std::string& text, const std::string& comment) {
    std::vector<std::vector<double>> found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.ends_with("   " + comment)) continue;
        std::istringstream words(line);
        found.emplace_back();
        for (double value = 0; words >> value;) found.back().push_back(value);
    }
    return found;
}

void expect_values(const std::string& text, const std::string& comment,
                   const std::vector<std::vector<double>>& expected) {
    const auto found = values_of(text, comment);
    ASSERT_EQ(found.size(), expected.size()) << text;
    for (std::size_t k = 0; k < found.size(); ++k) {
        ASSERT_EQ(found[k].size(), expected[k].size()) << text;
        for (std::size_t i = 0; i < found[k].size(); ++i)
            EXPECT_NEAR(found[k][i], expected[k][i], 1e-12) << comment << ' ' << k << ' ' << i;
    }
}

// F says which of x and y have a force; shifts are those of a step, in mm, and the indenter's:
// forces are on it, against those on the substrate.
TEST(ContactPaths, ShiftsAreShiftsAndForcesForces) {
    const std::string shifted =
        written(path_text("normal_force [N], shift_x [um]\n20, 0\n20, 50\n20, 20\n")).text;
    // The first case is pressed without friction.
    expect_values(shifted, "P-B-T-N-F-S", {{200100}, {1100}, {1100}});
    expect_values(shifted, "FN, CKSI, CETA, CPHI",
                  {{20, 0, 0, 0}, {20, .05, 0, 0}, {20, -.03, 0, 0}});
    const std::string forced =
        written(path_text("normal_force [N], tangential_force_x [N], tangential_force_y [N]\n"
                          "20, 0, 0\n20, 4, 3\n"))
            .text;
    expect_values(forced, "P-B-T-N-F-S", {{200100}, {1120}});
    expect_values(forced, "FN, FX, FY, CPHI", {{20, -.4, -.3, 0}});
    const std::string mixed =
        written(path_text("normal_force [N], tangential_force_x [N], shift_y [um]\n"
                          "20, 0, 0\n20, 4, 30\n"))
            .text;
    expect_values(mixed, "P-B-T-N-F-S", {{200100}, {1110}});
    expect_values(mixed, "FN, FX, CETA, CPHI", {{20, -.4, .03, 0}});
}

// The twist of a step is about its own point, wherever the body is.
TEST(ContactPaths, TwistsAreAboutTheirCentre) {
    const std::string table =
        "normal_force [N], rotation [mrad], offset_x [mm]\n20, 0, 0\n20, 20, 0\n20, 15, 2\n";
    const std::string own = written(path_text(table)).text;
    expect_values(own, "FN, FX, FY, CPHI", {{20, 0, 0, .02}});
    expect_values(own, "FN, FX, FY, CPHI, SPINXO, SPINYO", {{20, 0, 0, -.005, 2, 0}});
    const std::string fixed =
        written(path_text(table, "centre_of_rotation = \"substrate\"\ncentre_y = \"3 mm\"\n")).text;
    expect_values(fixed, "FN, FX, FY, CPHI, SPINXO, SPINYO",
                  {{20, 0, 0, .02, 0, 3}, {20, 0, 0, -.005, 0, 3}});
}

void expect_refused(const std::string& table, const std::string& rule) {
    try {
        written(path_text(table));
        ADD_FAILURE() << "was written: " << table;
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find(rule), std::string::npos) << error.what();
    }
}

TEST(ContactPaths, RefusesWhatContactDoesNotPrescribe) {
    expect_refused("indentation [mm], tangential_force_x [N]\n0.4, 0\n0.4, 4\n",
                   "path.table: CONTACT takes F_T over F_N, which d does not determine");
    expect_refused("normal_force [N], shift_x [um], tangential_force_y [N]\n20, 0, 0\n20, 4, 3\n",
                   "path.table: CONTACT prescribes no shift along x beside a force along y");
    expect_refused("normal_force [N], shift_x [um], rotation [mrad]\n20, 0, 0\n20, 4, 3\n",
                   "path.table: CONTACT prescribes no shift along x beside a force along y");
}

/// What moves the indenter in a step at the place `at`, along an axis with a shift.
double moved(const SequenceStep& step, int axis, const Vector2& at) {
    const double arm = at[1 - axis] - step.centre[1 - axis];
    return step.along[axis].value + step.rotation * (axis == 0 ? -arm : arm);
}

// Random histories with twist and motion, forces and shifts: the numbers alone say them.
RC_GTEST_PROP(ContactPaths, RandomHistoriesComeBackFromTheirNumbers, ()) {
    const auto draw = [](int low, int high) { return *rc::gen::inRange(low, high); };
    const int kinds = draw(0, 3);  // forces, one of each, shifts
    std::string table = "normal_force [N], rotation [mrad], offset_x [mm], offset_y [mm]";
    table += kinds < 2 ? ", tangential_force_x [N]" : ", shift_x [um]";
    table += kinds < 1 ? ", tangential_force_y [N]\n" : ", shift_y [um]\n";
    const int n_rows = draw(2, 5);
    for (int row = 0; row < n_rows; ++row) {
        const bool first = row == 0;
        table += std::to_string(draw(10, 30));
        table += ", " + std::to_string(first ? 0 : draw(-20, 20));
        for (int d = 0; d < 2; ++d) table += ", " + std::to_string(.1 * draw(-20, 20));
        for (int d = 0; d < 2; ++d) table += ", " + std::to_string(first ? 0. : .1 * draw(-30, 30));
        table += "\n";
    }
    const std::string keys = std::string("centre_of_rotation = \"") +
                             (draw(0, 2) ? "indenter" : "substrate") + "\"\ncentre_x = \"" +
                             std::to_string(draw(-9, 9)) + " mm\"\ncentre_y = \"" +
                             std::to_string(draw(-9, 9)) + " mm\"\n";
    const std::vector<std::string> overrides{
        "path.steps=" + std::to_string(draw(1, 4)),
        "substrate.poisson=" + std::to_string(draw(0, 2) ? .5 : .3),
        "load.press_steps=" + std::to_string(draw(1, 4))};
    const Written first = written(path_text(table, keys), overrides);
    const Import found = import_cases(first.text, "drawn.inp", bem::is_coupled);
    RC_ASSERT(found.cases.size() == 1U && found.left_out.empty());
    const Case back = io::parse_case(found.cases[0].text, "back.toml");
    const auto a = sequence_of(first.c, first.coupled), b = sequence_of(back, first.coupled);
    RC_ASSERT(a.size() == b.size());
    // Where both have their origins apart: the cell that is nearest to the body.
    const Vector2 apart{a[0].offset[0] - b[0].offset[0], a[0].offset[1] - b[0].offset[1]};
    for (std::size_t k = 0; k < a.size(); ++k) {
        RC_ASSERT(a[k].tangential == b[k].tangential);
        RC_ASSERT(std::abs(a[k].normal.value / b[k].normal.value - 1) < 1e-9);
        for (const int d : {0, 1})
            RC_ASSERT(std::abs(a[k].offset[d] - b[k].offset[d] - apart[d]) < 1e-6 * first.cell);
        if (!a[k].tangential) continue;
        RC_ASSERT(std::abs(a[k].rotation - b[k].rotation) < 1e-12);
        for (const int d : {0, 1}) {
            RC_ASSERT(a[k].is_forced(d) == b[k].is_forced(d));
            const bool same =
                a[k].is_forced(d)
                    ? std::abs(a[k].along[d].value - b[k].along[d].value) < 1e-9
                    : std::abs(moved(a[k], d, apart) - moved(b[k], d, {0, 0})) < 1e-6 * 1e-6;
            RC_ASSERT(same);
        }
    }
}

}  // namespace
}  // namespace tricontact::contact_program::contact_path_test

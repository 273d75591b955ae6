// Input files of CONTACT: written from cases, read as cases, and both back again.

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "bem/settings.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact_program/import.h"
#include "contact_program/program_case.h"
#include "contact_program/sequence.h"
#include "io/case/case_reader.h"
#include "tests/unit/io/sphere_case.h"

namespace tricontact::contact_program::contact_program_test {
namespace {

using contact::Case;

const std::string sphere =
    "title = \"A rig % with a comment\"\n" + io::loaded_sphere + R"(press_steps = 3
[rolling]
amplitude = "1.3 mm"
steps_per_quarter = 2
periods = 2
run_all = true
[bem]
cells_per_radius = 5
)";

struct Written {
    Case c;
    contact::ContactPoints grid;
    bool coupled;
    std::string text;
};

Written written(const std::vector<std::string>& overrides = {}, const std::string& text = sphere) {
    Written out{io::parse_case(text, "case.toml", overrides), {}, false, {}};
    const auto compliance = bem::case_compliance(out.c, 1, bem::Body::half_space);
    out.grid = compliance->points();
    out.coupled = compliance->is_coupled();
    out.text = sequence_text(out.c, out.grid, out.coupled, {});
    return out;
}

void expect_close(double a, double b, const char* what) {
    EXPECT_NEAR(a, b, 1e-12 * std::max({1e-9, std::abs(a), std::abs(b)})) << what;
}

/// What is written of a case is read as a case that does the same.
void expect_same_back(const std::vector<std::string>& overrides, const std::string& text = sphere) {
    SCOPED_TRACE(testing::PrintToString(overrides));
    const Written first = written(overrides, text);
    const Import found = import_cases(first.text, "first.inp", bem::is_coupled);
    ASSERT_EQ(found.cases.size(), 1U);
    EXPECT_TRUE(found.left_out.empty());
    const ImportedCase& imported = found.cases[0];
    const Case back = io::parse_case(imported.text, "back.toml");
    const auto a = sequence_of(first.c, first.coupled), b = sequence_of(back, first.coupled);
    EXPECT_EQ(imported.n_steps(), a.size());
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].tangential, b[k].tangential);
        EXPECT_EQ(a[k].normal.kind, b[k].normal.kind);
        expect_close(a[k].normal.value, b[k].normal.value, "normal");
        expect_close(a[k].along[0].value, b[k].along[0].value, "tangential");
        for (int axis : {0, 1})
            EXPECT_NEAR(a[k].offset[axis], b[k].offset[axis], 1e-12 * first.grid.spacing[0]);
    }
    const auto pair = first.c.materials(), pair_back = back.materials();
    expect_close(pair.effective_modulus(), pair_back.effective_modulus(), "E*");
    expect_close(pair.effective_shear_modulus(), pair_back.effective_shear_modulus(), "G*");
    EXPECT_NEAR(pair.dundurs_beta(), pair_back.dundurs_beta(), 1e-14);
    EXPECT_EQ(first.c.indenter.material.has_value(), back.indenter.material.has_value());
    EXPECT_EQ(first.c.friction_coefficient(), back.friction_coefficient());
    EXPECT_EQ(first.c.of<bem::Settings>().tolerance, back.of<bem::Settings>().tolerance);
    expect_close(first.grid.spacing[0], *back.of<contact::Cells>().spacing, "spacing");
    EXPECT_EQ(first.c.is_line_contact(), back.is_line_contact());
    const auto body = first.c.make_indenter(), body_back = back.make_indenter();
    const double y = first.c.is_line_contact() ? 0 : -2e-3;
    expect_close(body->height(1e-3, y), body_back->height(1e-3, y), "height");
}

TEST(ContactProgram, RoundTripIsTheSameCase) {
    expect_same_back({});
    expect_same_back({"rolling.angle=30 deg", "rolling.steps=turning-points"});
    expect_same_back({"rolling.angle=-90 deg", "load.tangential_ratio=0"});
    expect_same_back({"indenter.young=206 GPa", "indenter.poisson=0.3"});
    expect_same_back({"substrate.poisson=0.3"});  // coupled: pressed with friction
    expect_same_back({"substrate.poisson=0.3", "load.press=frictionless"});
    expect_same_back({"indenter.young=9 MPa", "indenter.poisson=0.1"});
    expect_same_back({"indenter.shape=ellipsoid", "indenter.radius_y=90 mm"});
    expect_same_back({"load.tangential_ratio=0", "substrate.poisson=0.2"});
}

TEST(ContactProgram, RoundTripWithoutRolling) {
    const std::string still =
        sphere.substr(0, sphere.find("[rolling]")) + sphere.substr(sphere.find("[bem]"));
    expect_same_back({}, still);
    expect_same_back({"load.indentation=0.4 mm"}, still);
    expect_same_back({"substrate.poisson=0.3", "load.press_steps=1"}, still);
}

TEST(ContactProgram, RoundTripOfACylinder) {
    expect_same_back({"indenter.shape=cylinder", "indenter.length=80 mm"});
}

// CONTACT's own example "From Cattaneo to Carter": the force on body 1 is against the shift, and a
// body at x0 = 0.25 mm has h = A x^2 - 2 A x0 x + A x0^2.
// By its first corner or centre, and by a cell's size or the last corner or centre: the same cells.
TEST(ContactProgram, ReadsCellsInEachOfFourWays) {
    const std::string ways[] = {"1\n 90 33 -4.125 -4.125 0.25 0.25",
                                "2\n 90 33 -4.125 -4.125 18.375 4.125", "3\n 90 33 -4 -4 0.25 0.25",
                                "4\n 90 33 -4 -4 18.25 4"};
    for (const std::string& way : ways) {
        const auto cases = read_program_cases(
            " 3 module\n 201110\n 022020\n 0001341\n 100 100 30 1 1e-7\n 0.47 -0.6 0 0\n 0.4 0.4\n"
            " 0.28 0.28 1 1\n " +
                way + "\n 1 1\n 0.003 0 0.003 0 0 0\n 0 MODULE\n",
            "ways.inp");
        ASSERT_EQ(cases.size(), 1u);
        for (const int axis : {0, 1}) {
            EXPECT_NEAR(cases[0].first[axis], -4e-3, 1e-15) << way;
            EXPECT_NEAR(cases[0].spacing[axis], .25e-3, 1e-15) << way;
        }
    }
}

TEST(ContactProgram, ReadsAnExamplesStep) {
    const auto cases = read_program_cases(R"(% Values may be 0.5d0 or 5e-1, and go on
  3   module  % in further lines
  201110      P-B-T-N-F-S
  022020      L-D-C-M-Z-E
 0001341    H-G-I-A-O-W-R
   100, 100, 30
   1 1d-7  MAXOUT, EPS
  0.4705  -0.657 0.000 0.000         FN, FX, CETA, CPHI
  0.4013  0.4013
  0.280       0.280       1.000       1.000
    1                                               IPOTCN
   90   33   -4.125    -4.125    0.250   0.250
       1           1
 0.002963  0.000  0.002963  0.0000000  0.000  0.0000000
 3  MODULE
  001010
  100020
 0011341
   100   100    30     1      1e-7
  0.07258    -0.657       0.000       0.000
       1           1
 0.002963  0.000  0.002963 -0.0014815  0.000  0.0001852   B(I), I=1, 6
 0 MODULE
 what comes after the end is not read
)",
                                          "example.inp");
    ASSERT_EQ(cases.size(), 2U);
    EXPECT_EQ(cases[0].digits.line, 3);
    EXPECT_EQ(cases[0].tolerance, 1e-7);
    EXPECT_EQ(cases[0].normal, .4705);
    EXPECT_EQ(cases[0].step.along[0].value, .657);  // on the substrate
    EXPECT_EQ(cases[0].friction_coefficient, .4013);
    EXPECT_EQ(cases[0].shear_modulus[1], 1e6);
    EXPECT_EQ(cases[0].n_x, 90);
    EXPECT_NEAR(cases[0].first[0], -4e-3, 1e-12);
    EXPECT_NEAR(cases[1].normal, .07258e-3, 1e-12);  // a depth
    EXPECT_EQ(cases[1].friction_coefficient, .4013);
    EXPECT_NEAR(cases[1].distance.curvature[0], 2.963, 1e-12);
    EXPECT_NEAR(cases[1].distance.offset[0], .25e-3, 1e-12);
    EXPECT_EQ(cases[1].distance.offset[1], 0);
}

/// The words of the first line with `key`.
std::vector<std::string> words_with(const std::string& text, const std::string& key) {
    const std::size_t at = text.find(key), begin = text.rfind('\n', at) + 1;
    std::istringstream line(text.substr(begin, at - begin));
    std::vector<std::string> words;
    for (std::string word; line >> word;) words.push_back(word);
    return words;
}

// The thesis' way of rolling: a new case per step, P = 0 but in the first, T = 1.
TEST(ContactProgram, WritesWorldFixedSteps) {
    const Written rig = written();
    EXPECT_EQ(rig.text.rfind("% A rig % with a comment\n", 0), 0U);
    const auto cases = read_program_cases(rig.text, "rig.inp");
    ASSERT_EQ(cases.size(), 2U + 2 * 8);
    EXPECT_EQ(cases[0].digits.previous, 2);
    EXPECT_EQ(cases[0].digits.tangential, 0);
    for (std::size_t k = 1; k < cases.size(); ++k) {
        EXPECT_EQ(cases[k].digits.previous, 0);
        EXPECT_EQ(cases[k].digits.tangential, 1);
        EXPECT_EQ(cases[k].digits.force, 2);
        EXPECT_NEAR(cases[k].step.along[0].value, .56, 1e-15);
    }
    EXPECT_NEAR(cases[2].distance.offset[0], .65e-3, 1e-15);
    EXPECT_NEAR(cases[3].distance.offset[0], 1.3e-3, 1e-15);
    EXPECT_NEAR(cases[7].distance.offset[0], -1.3e-3, 1e-15);
    EXPECT_EQ(cases[0].n_x, rig.grid.n_x);
    EXPECT_EQ(cases[0].n_y, rig.grid.n_y);
    for (int axis : {0, 1}) EXPECT_NEAR(cases[0].first[axis], rig.grid.first[axis], 1e-15);
    const auto materials = words_with(rig.text, "POISS 1,2");
    ASSERT_EQ(materials.size(), 4U);
    EXPECT_NEAR(std::stod(materials[3]), 5.2 / 3, 1e-12);  // N/mm^2
    EXPECT_NEAR(std::stod(materials[2]) / std::stod(materials[3]), 1e10, 1);
}

// A ball's exact profile is no parabola: its heights stand there, row by row.
TEST(ContactProgram, OtherBodiesByTheirHeights) {
    const Written ball = written({"indenter.shape=sphere", "rolling.steps=turning-points"});
    std::istringstream text(ball.text.substr(ball.text.find("% row by row\n") + 13));
    const double R = 40;
    for (int j = 0; j < ball.grid.n_y; ++j)
        for (int i = 0; i < ball.grid.n_x; ++i) {
            double h = -1;
            text >> h;
            const std::size_t k = static_cast<std::size_t>(j) * ball.grid.n_x + i;
            const double r = 1e3 * std::hypot(ball.grid.x[k], ball.grid.y[k]);
            ASSERT_NEAR(h, R - std::sqrt(R * R - r * r), 1e-12);
        }
    // Its heights move from case to case.
    EXPECT_THROW(import_cases(ball.text, "ball.inp", bem::is_coupled), contact::InputError);
}

TEST(ContactProgram, NamesTheFileOfCoefficients) {
    const Written rig = written();
    const std::string text = sequence_text(rig.c, rig.grid, true, "layer.influence");
    EXPECT_NE(text.find(" 0029020 "), std::string::npos);
    EXPECT_LT(text.find(" 'layer.influence'   CFNAME"), text.find("POISS 1,2"));
    EXPECT_EQ(words_with(text, "MAXGS")[3], "50");
    EXPECT_EQ(words_with(rig.text, "MAXGS")[3], "1");
}

std::string refusal(const std::vector<std::string>& overrides, const std::string& text = sphere) {
    try {
        sequence_of(io::parse_case(text, "case.toml", overrides), false);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ContactProgram, RefusesWhatASequenceCannotSay) {
    const auto expect = [](const std::vector<std::string>& overrides, const std::string& begin) {
        const std::string message = refusal(overrides);
        EXPECT_EQ(message.rfind(begin, 0), 0U) << message;
    };
    expect({"load.indentation=0.4 mm"}, "load.indentation: CONTACT takes F_T over the F_N");
    expect({"rolling.amplitude_ratio=0.2", "rolling.amplitude_reference=model"},
           "rolling.amplitude_reference: ");
    expect({"substrate.poisson=-0.2", "contact.coupling=false"}, "poisson: CONTACT takes");
    const Case c =
        io::parse_case(sphere, "case.toml", {"substrate.poisson=0.3", "contact.coupling=false"});
    EXPECT_THROW(sequence_of(c, true), contact::InputError);
    EXPECT_THROW(
        sequence_text(io::parse_case(sphere, "case.toml"),
                      contact::ContactPoints::grid(2001, 1000, {0, 0}, {1e-5, 1e-5}), false, {}),
        contact::InputError);
}

}  // namespace
}  // namespace tricontact::contact_program::contact_program_test

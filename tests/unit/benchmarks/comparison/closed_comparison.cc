// Problems with a closed form: what is exact passes, what is wrong by a known mistake fails.

#include "benchmarks/comparison/closed_comparison.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks/problems/problem.h"
#include "benchmarks/reference/closed_reference.h"
#include "benchmarks/submissions/read_field.h"
#include "benchmarks/submissions/table_field.h"
#include "contact/base/error.h"
#include "tests/paths.h"

namespace tricontact::benchmarks::closed_comparison_test {
namespace {

using std::numbers::pi;

Submission submission_of(const std::string& problem, const std::vector<std::string>& tables) {
    Submission s{.problem = problem};
    for (const std::string& text : tables)
        s.meshes.push_back(parse_table(text, fmt::format("mesh_{}.csv", s.meshes.size() + 1)));
    return s;
}

Comparison compared(const std::string& problem, const std::vector<std::string>& tables) {
    return compare_closed(submission_of(problem, tables));
}

std::string refusal(const std::string& problem, const std::string& table) {
    try {
        compared(problem, {table});
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

const ComparedNumber& number(const Comparison& c, const std::string& key) {
    return *std::ranges::find(c.numbers, key, &ComparedNumber::key);
}

/// Pressures [MPa] at n + 1 points of the interface, those of even points larger and those of odd
/// ones smaller by a share, and their displacement.
std::string patch_table(int n, double pressure = .1, double alternation = 0,
                        const std::string& head = "x [mm], p [MPa], uy [mm]") {
    std::string text = head + '\n';
    for (int i = 0; i <= n; ++i)
        text += fmt::format("{}, {:.15g}, -50\n", 1000. * i / n,
                            pressure * (1 + (i % 2 == 0 ? alternation : -alternation)));
    return text;
}

TEST(PatchTest, UniformPressurePassesOnAnyMeshes) {
    // Neither a family nor in the order of their sizes: nothing is extrapolated.
    const Comparison c = compared("patch_test", {patch_table(7), patch_table(3), patch_table(4)});
    EXPECT_EQ(c.standing, Standing::pass);
    EXPECT_NEAR(number(c, "pressure_deviation").difference, 0, 1e-14);
    EXPECT_NEAR(number(c, "displacement").difference, 0, 1e-14);
    EXPECT_FALSE(number(c, "peak_pressure").limit);
    EXPECT_TRUE(c.diagnoses.empty());
    EXPECT_EQ(compared("patch_test", {patch_table(5)}).standing, Standing::pass)
        << "one mesh decides";
}

// Contact of nodes with a surface in one pass: errors at the nodes which do not fall.
TEST(PatchTest, AlternatingPressureFailsHoweverFineTheMesh) {
    const Comparison c = compared("patch_test", {patch_table(3), patch_table(9, .1, .002)});
    EXPECT_EQ(c.standing, Standing::fail);
    EXPECT_NEAR(number(c, "pressure_deviation").difference, .002, 1e-12);
    ASSERT_FALSE(c.diagnoses.empty());
    EXPECT_EQ(c.diagnoses.front().id, "patch_test");
    // A fine mesh that passes does not excuse a coarse one.
    EXPECT_EQ(compared("patch_test", {patch_table(3, .1, .2), patch_table(9)}).standing,
              Standing::fail);
}

TEST(PatchTest, UniformPressureOfAnotherStrainFails) {
    // Of one block of 1000 mm in place of two of 500 mm each: twice the strain in it.
    const Comparison c = compared("patch_test", {patch_table(5, .2)});
    EXPECT_EQ(c.standing, Standing::fail);
    EXPECT_EQ(number(c, "pressure_deviation").standing, Standing::pass);
    EXPECT_NEAR(number(c, "peak_pressure").difference, 1, 1e-12);
}

// Springs in series: p (H/E + 1/K) = 100 mm.
TEST(PatchTest, PenaltyExplainsTheMeanExactly) {
    const double stiffness = 1e8;  // 0.1 MPa/mm, beside E/H = 0.001 MPa/mm
    const double pressure = .1 / (1 / 1e6 + 1 / stiffness) / 1e6;
    Submission s = submission_of("patch_test", {patch_table(5, pressure)});
    s.tolerances.usual = .005;
    EXPECT_EQ(compare_closed(s).standing, Standing::fail);
    s.contact.stiffness = stiffness;
    const Comparison c = compare_closed(s);
    const ComparedNumber& peak = number(c, "peak_pressure");
    EXPECT_EQ(peak.standing, Standing::pass);
    EXPECT_EQ(peak.unexplained_standing, Standing::fail);
    EXPECT_NEAR(peak.left(), 0, 1e-12);
    EXPECT_NEAR(peak.difference, -1. / 101, 1e-12);
}

TEST(PatchTest, FindsUnitsAndSign) {
    const Comparison c = compared("patch_test", {patch_table(5, -1e5, 0, "x, p, uy")});
    EXPECT_EQ(c.standing, Standing::pass);
    const auto has = [&](const std::string& id, const std::string& text) {
        return std::ranges::any_of(c.conventions, [&](const Convention& one) {
            return one.id == id && one.choice.find(text) != std::string::npos;
        });
    };
    EXPECT_TRUE(has("kind", "in Pa"));
    EXPECT_TRUE(has("sign", "tension"));
}

TEST(PatchTest, RefusesWhatItCannotJudge) {
    EXPECT_NE(refusal("patch_test", "# normal_force = 100 N/mm\n").find("judged by the pressures"),
              std::string::npos);
    EXPECT_NE(refusal("patch_test", patch_table(4, 1, 0, "x [mm], fn [N], uy [mm]"))
                  .find("nodal forces, which are no pressures"),
              std::string::npos);
    EXPECT_NE(refusal("patch_test", patch_table(4, .02, 0, "x, p, uy")).find("not understood"),
              std::string::npos);
}

TEST(Wedge, StaticsPassAndMistakesFail) {
    // What CalculiX 2.20 has on the deck's meshes of n = 4, 8, 16: forces of the block's base.
    const Comparison ccx = compared(
        "wedge", {"# F_T = -412.354 N\n# F_N = 1000 N\n", "# F_T = -412.3519 N\n# F_N = 1000 N\n",
                  "# F_T = -412.3520 N\n# F_N = 1000 N\n"});
    EXPECT_EQ(ccx.standing, Standing::pass);
    EXPECT_NEAR(number(ccx, "force_ratio").difference, -4.7e-5, 1e-6);
    const double alpha = std::atan(.1), phi = std::atan(.3);
    const Comparison exact =
        compared("wedge", {fmt::format("# force_ratio = {:.12g}\n", std::tan(alpha + phi))});
    EXPECT_EQ(exact.standing, Standing::pass);
    EXPECT_NEAR(number(exact, "force_ratio").difference, 0, 1e-11);
    const Comparison level = compared("wedge", {"# force_ratio = 0.4\n"});
    EXPECT_EQ(level.standing, Standing::fail);
    ASSERT_FALSE(level.diagnoses.empty());
    EXPECT_NE(level.diagnoses[0].sentence.find("along the level"), std::string::npos);
    const Comparison down =
        compared("wedge", {fmt::format("# force_ratio = {:.12g}\n", std::tan(alpha - phi))});
    EXPECT_EQ(down.standing, Standing::fail);
    EXPECT_NE(down.diagnoses[0].sentence.find("slides down"), std::string::npos);
    EXPECT_NE(refusal("wedge", "x [mm], p [MPa]\n0, 25\n1, 25\n").find("judged by F/G"),
              std::string::npos);
}

/// Means of the pressure of a punch over cells about the nodes of n elements in the radius, whose
/// load is F (1 - sqrt(1 - r^2/a^2)).
std::string punch_table(int n, double force, const std::string& totals = {}) {
    const double h = 5. / n;
    const auto load = [&](double r) {
        return force * (1 - std::sqrt(1 - std::pow(std::min(r, 5.) / 5, 2)));
    };
    std::string text = fmt::format("# size = {} mm\n{}r [mm], p [MPa]\n", h, totals);
    for (int i = 0; i < n + 3; ++i) {
        const double low = std::max(0., (i - .5) * h), high = (i + .5) * h;
        text += fmt::format("{:.12g}, {:.15g}\n", i * h,
                            (load(high) - load(low)) / (pi * (high * high - low * low)));
    }
    return text;
}

TEST(CompletePunch, ExactPressurePassesAndPlaneStressFails) {
    const Comparison exact =
        compared("complete_punch", {punch_table(8, 20), punch_table(16, 20), punch_table(32, 20)});
    EXPECT_EQ(exact.standing, Standing::pass);
    for (const char* key : {"normal_force", "pressure_at_axis", "pressure_at_0_9", "load_within"})
        EXPECT_NEAR(number(exact, key).difference, 0, 1e-9) << key;
    for (const char* key : {"pressure_l2", "peak_pressure", "contact_radius"})
        EXPECT_EQ(std::ranges::find(exact.numbers, key, &ComparedNumber::key), exact.numbers.end())
            << key;
    // E in place of E/(1 - nu^2).
    const Comparison wrong = compared(
        "complete_punch", {punch_table(8, 18.2), punch_table(16, 18.2), punch_table(32, 18.2)});
    EXPECT_EQ(wrong.standing, Standing::fail);
    EXPECT_NEAR(number(wrong, "pressure_at_axis").difference, -.09, 1e-9);
}

TEST(CompletePunch, IsJudgedByDepthWherePressedByForce) {
    std::vector<std::string> tables;
    for (const int n : {8, 16, 32})
        tables.push_back(punch_table(n, 20,
                                     fmt::format("# normal_force = 20 N\n"
                                                 "# indentation = {:.12g} mm\n",
                                                 .35 * (1 - .1 / n))));
    const Comparison c = compared("complete_punch", tables);
    EXPECT_EQ(c.standing, Standing::pass);
    EXPECT_NEAR(number(c, "indentation").difference, 0, 1e-9) << "extrapolated at the order 1";
    EXPECT_NEAR(number(c, "indentation").finest, -.1 / 32, 1e-9);
}

// The references are those of the catalogue.
TEST(ClosedComparison, ReferencesAreTheTargets) {
    for (const auto& [name, reference] :
         {std::pair{"patch_test", patch_test_reference()}, std::pair{"wedge", wedge_reference()},
          std::pair{"complete_punch", complete_punch_reference(true)},
          std::pair{"rounded_punch_plane", rounded_punch_plane_reference()},
          std::pair{"pin_in_hole", pin_in_hole_reference()}}) {
        EXPECT_TRUE(has_closed_comparison(name));
        for (const Target& target : required_problem(name).targets) {
            if (!target.is_solution) continue;
            const ReferenceValue* value = reference.find(target.key);
            ASSERT_NE(value, nullptr) << target.key;
            EXPECT_NEAR(value->value / target.value, 1, 2e-7) << name << ": " << target.key;
        }
    }
    EXPECT_FALSE(has_closed_comparison("layer_pressed"));
}

// p a/P at b/a = .5 by the integral equation, five digits.
TEST(RoundedPunch, PressuresOfItsIntegralEquation) {
    const Reference r = rounded_punch_plane_reference();
    const double load = .307092 * 5.2e6 / .91 * .01 * .01 / .1, a = .01;
    EXPECT_NEAR(r.find("normal_force")->value, load, 2e-6 * load);
    for (const auto& [place, pressure] : {std::pair{0., .40292}, std::pair{.3, .44017},
                                          std::pair{.6, .66610}, std::pair{.95, .33243}})
        EXPECT_NEAR(r.fields->at(place * a, 0).pressure * a / load, pressure, 1e-5) << place;
    EXPECT_NEAR(r.fields->load_within(a), load, 1e-5 * load);
    EXPECT_EQ(r.fields->at(1.001 * a, 0).pressure, 0);
}

/// Results of another code, pressures times a factor at so many times the distance.
Comparison foreign_result(const std::string& problem, const std::string& code,
                          const std::vector<const char*>& meshes, double pressure = 1,
                          double place = 1) {
    Submission s{.problem = problem};
    for (const char* n : meshes) {
        MeshField& mesh =
            s.meshes.emplace_back(read_field({.file = paths::source("tests/benchmarks/foreign/") +
                                                      code + "_" + problem + "_" + n + ".csv",
                                              .set = "",
                                              .totals = ""}));
        for (FieldColumn& column : mesh.columns)
            for (double& value : column.values)
                value *= column.meaning == Meaning::pressure ? pressure : place;
    }
    s.contact.kinematics = ContactMethod::Kinematics::undeformed;
    return compare_closed(std::move(s));
}

/// Of GetFEM 5.4.2.
Comparison getfem_punch(double pressure, double place) {
    return foreign_result("rounded_punch_plane", "getfem_q2", {"4", "8", "16", "32"}, pressure,
                          place);
}

TEST(RoundedPunch, GetfemPasses) {
    const Comparison c = getfem_punch(1, 1);
    EXPECT_EQ(c.standing, Standing::pass) << c.blame;
    EXPECT_LT(std::abs(number(c, "contact_radius").finest), 5e-4);
    EXPECT_LT(std::abs(number(c, "pressure_at_axis").finest), 3e-4);
}

// The same force on a contact that is 4 % narrower.
TEST(RoundedPunch, NarrowerContactFails) {
    EXPECT_EQ(getfem_punch(1 / .96, .96).standing, Standing::fail);
}

// E* DR/Q and R pmax/Q at 30 degrees by exact Fourier kernels of disc and hole; the projection of p
// is the force.
TEST(PinInHole, PressuresOfExactKernels) {
    const Reference r = pin_in_hole_reference();
    const double load = r.find("normal_force")->value;
    EXPECT_NEAR(210e9 / .91 * 2e-5 / load, 7.94354, 1e-5);
    EXPECT_NEAR(.01 * r.find("peak_pressure")->value / load, 1.260289, 1e-6);
    EXPECT_NEAR(r.fields->load_within(.005), load, 1e-6 * load);
    EXPECT_NEAR(r.fields->at(.003, 0).pressure, r.fields->at(-.003, 0).pressure, 1e-6);
    EXPECT_EQ(r.fields->at(.005001, 0).pressure, 0);
    // By its own rule over x, whose root at the edge leaves 1e-4.
    double sum = 0;
    constexpr int n = 4000;
    for (int i = 0; i < n; ++i) sum += r.fields->at(.003 * (i + .5) / n, 0).pressure * .006 / n;
    EXPECT_NEAR(r.fields->load_within(.003), sum, 1e-4 * load);
}

// Two bodies by the decks' mortar, FreeFem++ 4.11 with P2 and GetFEM 5.4.2 with Q2: on 16 elements
// in a, the order of the peak is 2.
TEST(PinInHole, FreefemAndGetfemPass) {
    for (const char* code : {"freefem_p2", "getfem_q2"}) {
        const Comparison c = foreign_result("pin_in_hole", code, {"4", "8", "16"});
        EXPECT_EQ(c.standing, Standing::pass) << c.blame;
        EXPECT_LT(std::abs(number(c, "contact_radius").finest), 3e-3) << code;
        EXPECT_LT(std::abs(number(c, "peak_pressure").finest), 1e-3) << code;
        const Comparison stiffer = foreign_result("pin_in_hole", code, {"4", "8", "16"}, 1.04);
        EXPECT_EQ(stiffer.standing, Standing::fail) << code;
    }
}

}  // namespace
}  // namespace tricontact::benchmarks::closed_comparison_test

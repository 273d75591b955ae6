#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "experiments/assumptions/rig.h"
#include "experiments/rig_report/rig_report.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::rig_reader_test {
namespace {

const std::string rolling = R"(title = "a rig"
models = ["bem"]
[indenter]
radius = "40.0 ± 0.1 mm"
young = "206 GPa"
poisson = 0.3
[substrate]
thickness = "8 mm"
young = "5.2 MPa"
poisson = "0.49 ± 0.01"
[friction]
coefficient = 0.57
[load]
normal_force = "21.1 N"
tangential_ratio = 0.5
[rolling]
amplitude_ratio = 0.3
speed = "1 mm/s"
[rig]
smallest_amplitude_ratio = 0.25
)";

experiments::Rig rig_of(const std::string& text) {
    return experiments::rolling_rig(io::parse_rig_file(text, "rig.toml"));
}

std::string message_of(const std::string& text) {
    try {
        rig_of(text);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

TEST(RigReader, ReadsQuantitiesWithTheirErrors) {
    const auto rig = rig_of(rolling);
    EXPECT_EQ(rig.title, "a rig");
    EXPECT_DOUBLE_EQ(rig.R.value, 40e-3);
    EXPECT_DOUBLE_EQ(rig.R.standard_error, 0.1e-3);
    EXPECT_DOUBLE_EQ(rig.nu_2.standard_error, 0.01);
    EXPECT_EQ(rig.F_N.standard_error, 0);
    EXPECT_FALSE(rig.DU.is_known());
    EXPECT_FALSE(rig.eta.is_known());
}

TEST(RigReader, KeepsPrintedNumbersWithTheirLastDigit) {
    const auto rig = rig_of(
        rolling + "[printed]\ncontact_radius = {value = \"4.56 mm\", source = \"table 1\"}\n");
    ASSERT_EQ(rig.printed.size(), 1U);
    EXPECT_EQ(rig.printed[0].name, "contact_radius");
    EXPECT_EQ(rig.printed[0].text, "4.56 mm");
    EXPECT_EQ(rig.printed[0].source, "table 1");
    EXPECT_DOUBLE_EQ(rig.printed[0].value.value, 4.56e-3);
    EXPECT_DOUBLE_EQ(rig.printed[0].half_digit, 0.005e-3);
}

TEST(RigReader, RefusesWithPlaceRuleAndRemedy) {
    using Pair = std::pair<std::string, std::string>;
    const std::string with_print = rolling + "[printed]\n";
    for (const auto& [text, message] :
         {Pair{replaced(rolling, "40.0 ± 0.1 mm", "40 mm ± 0.1"),
               "rig.toml:4:10: indenter.radius = \"40 mm ± 0.1\": the error behind ± has no unit"},
          Pair{replaced(rolling, "40.0 ± 0.1 mm", "40.0 ± 50 mm"),
               "rig.toml:4:10: indenter.radius = \"40.0 ± 50 mm\": with its error it must be"},
          Pair{replaced(rolling, "0.49 ± 0.01", "0.5 ± 0.01"),
               "rig.toml:10:11: substrate.poisson = \"0.5 ± 0.01\": with its error it must be"},
          Pair{replaced(rolling, "[rig]\n", "[rig]\neigenfreqency = \"22 Hz\"\n"),
               "unknown key rig.eigenfreqency; did you mean rig.eigenfrequency?"},
          Pair{replaced(rolling, "[rig]\n", "[rig]\neigenfrequency = \"22 mm\"\n"),
               "\"mm\" is a unit of length"},
          Pair{replaced(rolling, "[rig]", "[rgi]"), "unknown section [rgi]; did you mean rig?"},
          Pair{replaced(replaced(rolling, "thickness = \"8 mm\"\n", ""),
                        "radius = ", "shape = \"ellipsoid\"\nradius_y = \"60 mm\"\nradius = "),
               "missing key substrate.thickness"},
          Pair{rolling + "specimen_thickness = \"9 mm\"\n",
               "describes rigs on a half-space, and the case has a layer"},
          Pair{replaced(rolling, "normal_force = \"21.1 N\"", "indentation = \"0.3 mm\""),
               "missing key load.normal_force; give the force, not the indentation"},
          Pair{replaced(rolling, "thickness =", "base = \"frictionless\"\nthickness ="),
               "one layer bonded to a rigid base"},
          Pair{rolling + "pivot_displacement = \"1 um\"\n",
               "has no effect without rig.pivot_amplitude_ratio"},
          Pair{rolling + "axis_tilt = \"0 ± 0.1 deg\"\n",
               "rig.axis_tilt = \"0 ± 0.1 deg\": has no effect without an axis"},
          Pair{rolling + "tilt = \"0.1 ± 0.05 mm\"\n", "\"mm\" is a unit of length"},
          Pair{rolling + "tilt = \"40 ± 6 deg\"\n", "with its error it must be"},
          Pair{rolling + "[bem]\nspacing = \"0.2 ± 0.1 mm\"\n",
               "is a setting of the computation, and has no uncertainty"},
          Pair{with_print + "radius = {value = \"1 mm\", source = \"x\"}\n",
               "unknown printed quantity radius"},
          Pair{with_print + "contact_radius = \"1 mm\"\n", "must be a table"},
          Pair{with_print + "contact_radius = {value = \"1 mm\"}\n",
               "missing key printed.contact_radius.source"},
          Pair{with_print + "contact_radius = {value = 1, source = \"x\"}\n",
               "must be a text in quotes"},
          Pair{with_print + "contact_radius = {value = \"1 N\", source = \"x\"}\n",
               "\"N\" is a unit of force"},
          Pair{with_print +
                   "contact_radius = {valeu = \"1 mm\", source = \"x\", value = \"1 mm\"}\n",
               "did you mean value?"}}) {
        const std::string told = message_of(text);
        EXPECT_NE(told.find(message), std::string::npos) << told << "\nlacks " << message;
        EXPECT_TRUE(told.starts_with("rig.toml:")) << told;
    }
}

// Zero is in the middle of a tilt's range, and its error goes to both sides.
TEST(RigReader, ReadsTiltsAboutZero) {
    const auto rig = rig_of(rolling + "tilt = \"0 ± 0.2 deg\"\n");
    EXPECT_EQ(rig.theta.value, 0);
    EXPECT_NEAR(rig.theta.standard_error, .2 * std::numbers::pi / 180, 1e-12);
    const auto falling = rig_of(rolling + "tilt = \"-0.1 ± 0.05 deg\"\n");
    EXPECT_NEAR(falling.theta.value, -.1 * std::numbers::pi / 180, 1e-12);
    EXPECT_DOUBLE_EQ(rig.f_T.value, .5);
}

// W along x, or along y; of a ratio w a, a of Hertz.
TEST(RigReader, KnowsHowFarTheRollerGoes) {
    const std::string text =
        replaced(rolling, "amplitude_ratio = 0.3", "amplitude = \"2 ± 0.1 mm\"");
    const auto along = rig_of(text);
    EXPECT_DOUBLE_EQ(along.W_x.value, 2e-3);
    EXPECT_DOUBLE_EQ(along.W_x.standard_error, .1e-3);
    EXPECT_EQ(along.W_y.value, 0);
    const auto across = rig_of(replaced(text, "speed =", "angle = \"90 deg\"\nspeed ="));
    EXPECT_NEAR(across.W_x.value, 0, 1e-15);
    EXPECT_DOUBLE_EQ(across.W_y.value, 2e-3);
    const double a = contact::half_space_scales([] {
                         contact::Case c;
                         c.indenter.radius = .04;
                         c.indenter.material = contact::Material{206e9, .3};
                         c.substrate = {5.2e6, .49};
                         c.load.normal_force = 21.1;
                         return c;
                     }())
                         .contact_radius;
    EXPECT_NEAR(rig_of(rolling).W_x.value, .3 * a, 1e-9 * a);
}

// What the case resolves is taken from there.
TEST(RigReader, TakesFromTheCaseWhatTheRigDoesNotSay) {
    const std::string bare =
        replaced(replaced(replaced(rolling, "young = \"206 GPa\"\npoisson = 0.3\n", ""),
                          "thickness = \"8 mm\"", "thickness_ratio = \"0.9 ± 0.09\""),
                 "smallest_amplitude_ratio = 0.25\n", "");
    const auto rig = rig_of(bare);
    EXPECT_EQ(rig.E_1.value, experiments::rigid_young);
    EXPECT_DOUBLE_EQ(rig.w.value, 0.3);
    // b = 0.9 * 2a, a of Hertz: 4.50 mm (Johnson 1985, (4.22)) for nu = 0.49
    const double plane = 5.2e6 / (1 - .49 * .49);
    EXPECT_NEAR(rig.b.value, 1.8 * std::cbrt(3 * 21.1 * 40e-3 / (4 * plane)), 1e-9);
    EXPECT_NEAR(rig.b.standard_error, rig.b.value / 10, 1e-9);
    const auto uncertain =
        rig_of(replaced(bare, "amplitude_ratio = 0.3", "amplitude_ratio = \"0.3 ± 0.02\""));
    EXPECT_DOUBLE_EQ(uncertain.w.value, 0.3);
    EXPECT_DOUBLE_EQ(uncertain.w.standard_error, .02);
    const auto report = experiments::check_rig(rig);
    EXPECT_NE(experiments::given_text(calculation_of(report, "contact_radius")).find("infinite"),
              std::string::npos);
}

// Formulas are those of the substrate at rest: of E_0 and g = 1 - G_inf/G_0 it has E_0 (1 - g), and
// the same part of the error.
TEST(RigReader, TakesTheRelaxedModulusOfAnUnrelaxedOne) {
    const auto with = [](const std::string& series) {
        return replaced(replaced(rolling, "young = \"5.2 MPa\"", "young = \"5.2 MPa ± 5 %\""),
                        "[friction]",
                        "[substrate.relaxation]\nmodulus = \"unrelaxed\"\n" + series +
                            "times = [\"1 s\"]\n[friction]");
    };
    const std::string relative = "relative_moduli = [0.6]\n", absolute = "moduli = [\"1 MPa\"]\n";
    const auto rig = rig_of(with(relative));
    EXPECT_NEAR(rig.E_2.value, .4 * 5.2e6, 1e-6);
    EXPECT_NEAR(rig.E_2.standard_error, .05 * .4 * 5.2e6, 1e-6);
    EXPECT_NEAR(rig.eta.value, .6 * 5.2e6 / (2 * 1.49), 1e-6);  // G_1 tau
    for (const std::string& other : {absolute, relative + "bulk = \"elastic\"\n"})
        EXPECT_NE(message_of(with(other)).find("only where all relaxes in proportion"),
                  std::string::npos)
            << message_of(with(other));
}

// A standard solid of the case: eta = G_2 tau.
TEST(RigReader, TakesTheStandardSolidOfTheCase) {
    const auto rig =
        rig_of(replaced(rolling, "[friction]",
                        "[substrate.relaxation]\nG2 = \"1 MPa\"\neta = \"40 Pa s\"\n[friction]"));
    EXPECT_NEAR(rig.eta.value, 40, 1e-9);
    EXPECT_NEAR(rig.G_ratio.value, 1e6 / (5.2e6 / 2 / 1.49), 1e-9);
    EXPECT_NE(message_of(replaced(rolling, "[friction]",
                                  "[substrate.relaxation]\nG2 = \"1 MPa\"\neta = \"40 Pa s\"\n"
                                  "[friction]") +
                         "viscosity = \"40 Pa s\"\n")
                  .find("omit one of the two"),
              std::string::npos);
}

// What is not stated is not testable, and the key that is missing is named.
TEST(RigReader, NamesTheKeysThatAreMissing) {
    const auto rig =
        rig_of(replaced(replaced(rolling, "speed = \"1 mm/s\"\n", ""),
                        "smallest_amplitude_ratio = 0.25\n", "eigenfrequency = \"22 Hz\"\n"));
    const auto report = experiments::check_rig(rig);
    const auto& missing = assumption_of(report, "quasi_static_drive").missing;
    EXPECT_EQ(missing, (std::vector<std::string>{"rolling.speed", "rig.density"}));
}

// Every printed quantity that files may name is computed for some rig in examples/rigs/.
TEST(RigReader, PrintedQuantitiesAreThoseThatTheProgramComputes) {
    const auto known = [](const std::vector<experiments::RigReport>& reports, const auto& keys) {
        for (const experiments::PrintedKey& key : keys) {
            bool found = false;
            for (const auto& report : reports)
                for (const auto& assumption : report.assumptions) {
                    for (const auto& one : assumption.background) found |= one.name == key.name;
                    for (const auto& one : assumption.criteria)
                        found |= one.calculation.name == key.name;
                }
            EXPECT_TRUE(found) << key.name;
        }
    };
    known({report_of("sphere_parallel"), report_of("cylinder_parallel")},
          experiments::printed_keys(experiments::Rig::Kind::sphere));
    known({report_of("micro_walking_set_5")},
          experiments::printed_keys(experiments::Rig::Kind::micro_walking));
}

}  // namespace
}  // namespace tricontact::rig_reader_test

#include <gtest/gtest.h>

#include <string>

#include "contact/error.h"
#include "experiments/assumptions/rig.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::rig_reader_test {
namespace {

const std::string rolling = R"(rig = "rolling"
title = "a rig"
[roller]
shape = "sphere"
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
[drive]
speed = "1 mm/s"
smallest_amplitude_ratio = 0.25
)";

std::string message_of(const std::string& text) {
    try {
        experiments::parse_rig(text, "rig.toml");
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

TEST(RigReader, ReadsQuantitiesWithTheirErrors) {
    const auto rig = experiments::parse_rig(rolling, "rig.toml");
    EXPECT_EQ(rig.title, "a rig");
    EXPECT_DOUBLE_EQ(rig["R"].value, 40e-3);
    EXPECT_DOUBLE_EQ(rig["R"].standard_error, 0.1e-3);
    EXPECT_DOUBLE_EQ(rig["nu_2"].standard_error, 0.01);
    EXPECT_EQ(rig["F_N"].standard_error, 0);
    EXPECT_FALSE(rig.has("DU"));
    EXPECT_FALSE(rig.has("eta"));
}

TEST(RigReader, KeepsPrintedNumbersWithTheirLastDigit) {
    const auto rig = experiments::parse_rig(
        rolling + "[printed]\ncontact_radius = {value = \"4.56 mm\", source = \"table 1\"}\n",
        "rig.toml");
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
         {Pair{"title = \"x\"\n", "rig.toml:1:1: missing key rig; add rig = \"rolling\""},
          Pair{replaced(rolling, "\"rolling\"", "\"rollin\""), "did you mean \"rolling\"?"},
          Pair{replaced(rolling, "40.0 ± 0.1 mm", "40 mm ± 0.1 mm"),
               "rig.toml:5:10: roller.radius = \"40 mm ± 0.1 mm\": the unit of value and error"},
          Pair{replaced(rolling, "40.0 ± 0.1 mm", "-40 mm"), "must be greater than 0 m"},
          Pair{replaced(rolling, "40.0 ± 0.1 mm", "40 N"), "\"N\" is a unit of force"},
          Pair{replaced(rolling, "poisson = 0.3", "poisson = 0.6"), "rig.toml:7:11"},
          Pair{replaced(rolling, "0.49 ± 0.01", "0.5 ± 0.01"),
               "rig.toml:11:11: substrate.poisson = \"0.5 ± 0.01\": with its error it must be"},
          Pair{replaced(rolling, "poisson = 0.3", "poisson = true"),
               "must be a pure number, but is a truth value"},
          Pair{replaced(rolling, "radius", "raduis"),
               "unknown key roller.raduis; did you mean roller.radius?"},
          Pair{replaced(rolling, "[drive]", "[drvie]"),
               "unknown section [drvie]; did you mean drive?"},
          Pair{replaced(rolling, "coefficient = 0.57\n", ""), "missing key friction.coefficient"},
          Pair{replaced(rolling, "[load]\nnormal_force = \"21.1 N\"\n", ""),
               "add a section [load] with normal_force"},
          Pair{replaced(rolling, "shape = \"sphere\"\n", ""), "missing key roller.shape"},
          Pair{replaced(rolling, "\"sphere\"", "\"cylinder\""), "missing key roller.length"},
          Pair{replaced(rolling, "shape =", "length = \"80 mm\"\nshape ="),
               "a sphere has no length"},
          Pair{rolling + "[pivot]\ndisplacement = \"1 um\"\n", "missing key pivot.amplitude_ratio"},
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

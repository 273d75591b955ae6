#include "io/case/rig_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "contact/base/error.h"
#include "io/case/case_reader.h"
#include "io/case/rig_keys.h"
#include "io/keys/field_reader.h"

namespace tricontact::io::rig_file_test {
namespace {

const std::string rig = R"x(models = ["bem-layer"]
[indenter]
radius = "40 ± 0.1 mm"
[substrate]
young = "5.2 MPa ± 5 %"
poisson = "0.49 ± 0.005"
thickness = "8 ± 0.1 mm (uniform)"
[friction]
coefficient = "0.57 ± 0.02 (triangular)"
[load]
normal_force = "21.1 N"
tangential_ratio = 0.5
[rolling]
amplitude_ratio = 0.2
[rig]
contact_size = "9.0 ± 0.5 mm"
[record]
kind = "shakedown"
runs = ["run.csv"]
[record.drive]
start = "30 s"
[measurement]
static_shift = "shift.csv"
[printed]
contact_radius = {value = "4.5 mm", source = "a note"}
)x";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

std::string message_of(const std::string& text) {
    try {
        parse_rig_file(text, "rig.toml");
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

// Who needs no uncertainties gets the case by the values alone.
TEST(RigFile, IsACaseByItsValues) {
    std::string exact = rig.substr(0, rig.find("[rig]"));
    for (const char* error : {" ± 0.1", " ± 5 %", " ± 0.1 mm (uniform)"})
        exact = replaced(exact, error, error == std::string(" ± 0.1 mm (uniform)") ? " mm" : "");
    exact = replaced(exact, "\"0.49 ± 0.005\"", "0.49");
    exact = replaced(exact, "\"0.57 ± 0.02 (triangular)\"", "0.57");
    EXPECT_EQ(write_case(parse_case(rig, "rig.toml")), write_case(parse_case(exact, "rig.toml")));
}

TEST(RigFile, KnowsWhatIsUncertain) {
    const RigFile file = parse_rig_file(rig, "rig.toml", {"load.normal_force=\"21 ± 1 N\""});
    ASSERT_EQ(file.uncertain.size(), 7U);
    EXPECT_EQ(file.uncertain_of_case().size(), 6U);  // contact_size is not one of the case
    const auto error_of = [&](std::string_view path) {
        for (const UncertainKey& one : file.uncertain)
            if (one.key->path == path) return one.number.value.standard_error;
        return 0.;
    };
    EXPECT_DOUBLE_EQ(error_of("substrate.young"), .05 * 5.2e6);
    EXPECT_DOUBLE_EQ(error_of("substrate.thickness"), .1e-3 / std::sqrt(3));
    EXPECT_DOUBLE_EQ(error_of("friction.coefficient"), .02 / std::sqrt(6));
    EXPECT_DOUBLE_EQ(error_of("load.normal_force"), 1);
    EXPECT_DOUBLE_EQ(error_of("rig.contact_size"), .5e-3);
}

// What only other commands read is checked all the same.
TEST(RigFile, RefusesWithPlaceRuleAndRemedy) {
    for (const auto& [what, by, message] :
         {std::tuple{"contact_size", "contact_sise",
                     "rig.toml:16:1: unknown key rig.contact_sise; did you mean rig.contact_size?"},
          std::tuple{"[record.drive]", "[record.driev]", "unknown section [record.driev]"},
          std::tuple{"\"shakedown\"", "\"shakedwn\"", "did you mean \"shakedown\"?"},
          std::tuple{"start = \"30 s\"", "start = \"30 m\"", "\"m\" is a unit of length"},
          std::tuple{"[\"run.csv\"]", "[]", "the list is empty"},
          std::tuple{"\"0.49 ± 0.005\"", "\"0.49 ± 0.02\"", "with its error it must be"},
          std::tuple{"\"21.1 N\"", "\"21.1 N ± 5\"", "the error behind ± has no unit"},
          std::tuple{"[rolling]\n", "[rolling]\nperiods = \"12 ± 1\"\n", "must be a whole number"},
          std::tuple{"[rig]", "[bem]\nspacing = \"0.2 ± 0.1 mm\"\n[rig]",
                     "is a setting of the computation, and has no uncertainty"}}) {
        const std::string told = message_of(replaced(rig, what, by));
        EXPECT_NE(told.find(message), std::string::npos) << told << "\nlacks " << message;
    }
}

// At the end of its range a number is uncertain to the other side.
TEST(RigFile, AnIncompressibleSubstrateMayBeLess) {
    EXPECT_EQ(message_of(replaced(rig, "0.49 ± 0.005", "0.5 ± 0.005")), "accepted");
}

TEST(RigFile, EveryKeyOfARigHasAMeaningAndAnExampleThatIsAccepted) {
    for (const auto* keys : {&rolling_rig_keys(), &walking_rig_keys()})
        for (const Key& key : *keys) {
            EXPECT_FALSE(key.text.empty()) << key.path;
            const Entry example{.path = std::string(key.path),
                                .value = parse_value(std::string(key.example)),
                                .place = "example",
                                .key_place = "example"};
            EXPECT_NO_THROW(read_field(key, example, {})) << key.path;
        }
}

}  // namespace
}  // namespace tricontact::io::rig_file_test

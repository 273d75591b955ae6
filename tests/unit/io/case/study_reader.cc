// Study files: what they mean, and the messages of bad ones.

#include "io/case/study_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <ostream>

#include "contact/base/error.h"
#include "tests/paths.h"
#include "walking/input/walk_keys.h"

namespace tricontact::io::study_reader_test {
namespace {

namespace fs = std::filesystem;

const std::string rig = paths::source("examples/cases/rig_layer_parallel.toml");
const std::string head = "case = \"" + rig + "\"\n";

Study parse(const std::string& text) {
    return parse_study(text, "study.toml", walking::walk_key_list());
}

std::string message_of(const std::string& text) {
    try {
        parse(text);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "(accepted)";
}

std::vector<std::string> values_of(const Study::Axis& axis, const std::vector<double>& fractions) {
    std::vector<std::string> values;
    for (const Entry& entry : entries_at(axis, fractions))
        values.push_back(table_value(*axis.key, entry));
    return values;
}

TEST(StudyReader, TakesListsRangesAndSamplesInTheirOrder) {
    const Study study = parse(head + R"(title = "all kinds"
levels = 2
[set]
rolling.steps = "turning-points"
[vary]
substrate.thickness = {from = "2 mm", to = "32 mm", points = 5, scale = "log"}
load.tangential_ratio = [0.1, 0.25]
rolling.amplitude_ratio = {from = 0.1, to = 0.5}
rolling.periods = {from = 10, to = 20, points = 3}
contact.coupling = [true, false]
[latin_hypercube]
points = 7
seed = 3
)");
    EXPECT_EQ(study.title, "all kinds");
    EXPECT_EQ(study.models, (std::vector<std::string>{"mdr", "bem", "fem"}));  // of the case
    EXPECT_EQ(study.levels, 2);
    ASSERT_EQ(study.settings.size(), 1U);
    EXPECT_EQ(study.settings[0].path, "rolling.steps");
    ASSERT_EQ(study.axes.size(), 5U);
    EXPECT_EQ(table_heading(*study.axes[0].key), "substrate.thickness_m");
    EXPECT_EQ(values_of(study.axes[0], {0, .25, .5, .75, 1}),
              (std::vector<std::string>{"0.002", "0.004", "0.008", "0.016", "0.032"}));
    const auto& list = std::get<std::vector<Entry>>(study.axes[1].values);
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(table_value(*study.axes[1].key, list[1]), "0.25");
    EXPECT_EQ(values_of(study.axes[2], {0, .3, 1}),
              (std::vector<std::string>{"0.1", "0.22", "0.5"}));
    EXPECT_FALSE(std::get<Study::Range>(study.axes[2].values).points);
    EXPECT_EQ(values_of(study.axes[3], {0, .5, 1}), (std::vector<std::string>{"10", "15", "20"}));
    EXPECT_EQ(
        table_value(*study.axes[4].key, std::get<std::vector<Entry>>(study.axes[4].values)[1]),
        "false");
    ASSERT_TRUE(study.sampling);
    EXPECT_EQ(study.sampling->points, 7);
    EXPECT_EQ(study.sampling->seed, 3U);
}

// Twelve digits of 0.1 + 0.4/3; whole numbers next to 10 + 10/3 and 10 + 20/3.
TEST(StudyReader, ValuesOfARangeAreRoundedToTwelveDigitsOrToTheNearestWholeNumber) {
    const Study study = parse(head + R"([vary]
rolling.amplitude_ratio = {from = 0.1, to = 0.5, points = 4}
rolling.periods = {from = 10, to = 20, points = 4}
)");
    EXPECT_EQ(values_of(study.axes[0], {0, 1. / 3, 1}),
              (std::vector<std::string>{"0.1", "0.233333333333", "0.5"}));
    EXPECT_EQ(values_of(study.axes[1], {0, 1. / 3, 2. / 3, 1}),
              (std::vector<std::string>{"10", "13", "17", "20"}));
}

TEST(StudyReader, KeepsTheEndsOfARangeWhateverTheirDigits) {
    const Study study = parse(head + R"([vary]
rolling.amplitude_ratio = {from = 0.12345678901234567, to = 0.3, points = 2}
)");
    const auto values = entries_at(study.axes[0], {0, 1});
    EXPECT_GE(std::get<double>(values[0].value), 0.12345678901234567);
    EXPECT_EQ(std::get<double>(values[1].value), 0.3);
}

TEST(StudyReader, FindsTheCaseBesideTheStudy) {
    const fs::path folder = fs::path(testing::TempDir()) / ("study-" + std::to_string(::getpid()));
    fs::create_directories(folder / "examples/cases");
    fs::copy_file(rig, folder / "examples/cases/rig.toml", fs::copy_options::overwrite_existing);
    std::ofstream(folder / "study.toml") << "case = \"examples/cases/rig.toml\"\n";
    const Study study = read_study((folder / "study.toml").string(), walking::walk_key_list());
    EXPECT_EQ(study.base.name, (folder / "examples/cases/rig.toml").string());
    EXPECT_TRUE(study.axes.empty());
    fs::remove_all(folder);
}

struct Bad {
    const char* name;
    std::string text;
    std::string expected;
};

// What CTest shows of a parameter: no addresses.
void PrintTo(const Bad& bad, std::ostream* out) {
    *out << bad.name;
}

class BadStudy : public testing::TestWithParam<Bad> {};

TEST_P(BadStudy, IsRefusedWithPlaceRuleAndRemedy) {
    const std::string message = message_of(GetParam().text);
    EXPECT_NE(message.find(GetParam().expected), std::string::npos)
        << "expected: " << GetParam().expected << "\n     got: " << message;
    EXPECT_EQ(message.rfind("study.toml:", 0), 0U) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
}

std::string vary(const std::string& line) {
    return head + "[vary]\n" + line + "\n";
}

INSTANTIATE_TEST_SUITE_P(
    Texts, BadStudy,
    testing::Values(
        Bad{"NoCase", "models = [\"mdr\"]", "missing key case; add"},
        Bad{"CaseMissing", "case = \"gone.toml\"",
            "study.toml:1:8: case = \"gone.toml\": gone.toml: the file cannot be read"},
        Bad{"NoToml", "case =", "not valid TOML"},
        Bad{"KeyUnknown", head + "modells = [\"mdr\"]",
            "study.toml:2:1: unknown key modells; did you mean models?"},
        Bad{"SectionUnknown", head + "[varys]\n",
            "study.toml:2:1: unknown section [varys]; did you mean vary?"},
        Bad{"SectionAsKey", head + "vary = 3", "write [vary] on its own line"},
        Bad{"SectionAsList", head + "[[vary]]\nload.tangential_ratio = [0.1]",
            "write [vary] on its own line"},
        Bad{"ModelUnknown", head + "models = [\"bam\"]", "study.toml:2:10: models"},
        Bad{"LevelsZero", head + "levels = 0", "levels = 0: must be at least 1"},
        Bad{"CaseKeyUnknown", vary("load.tangential_ration = [0.1]"),
            "study.toml:3:6: unknown key vary.load.tangential_ration: the case has no key "
            "load.tangential_ration; did you mean load.tangential_ratio?"},
        Bad{"ListEmpty", vary("load.tangential_ratio = []"),
            "vary.load.tangential_ratio = []: the list is empty"},
        Bad{"ValueOutOfRange", vary("load.tangential_ratio = [0.1, 1.5]"),
            "study.toml:3:25: load.tangential_ratio = 1.5: must be"},
        Bad{"ValueTwice", vary("substrate.thickness = [\"8 mm\", \"0.8 cm\"]"),
            "vary.substrate.thickness: 0.008 stands twice"},
        Bad{"ValueWithoutUnit", vary("substrate.thickness = [8]"),
            "must be a length, but has no unit"},
        Bad{"ValueOfOtherUnit", vary("substrate.thickness = [\"8 N\"]"), "is a unit of force"},
        Bad{"Scalar", vary("load.tangential_ratio = 0.1"), "must be a list or a range"},
        Bad{"RangeEmpty", vary("load.tangential_ratio = {}"),
            "[vary.load.tangential_ratio] is empty"},
        Bad{"RangeWithoutEnd", vary("load.tangential_ratio = {from = 0.1, points = 3}"),
            "the range has no to"},
        Bad{"RangeFalls", vary("load.tangential_ratio = {from = 0.3, to = 0.1, points = 3}"),
            "must be greater than from"},
        Bad{"RangeOfOnePoint", vary("load.tangential_ratio = {from = 0.1, to = 0.3, points = 1}"),
            "points = 1: must be at least 2"},
        Bad{"RangeOfTooFewWholeNumbers", vary("rolling.periods = {from = 10, to = 12, points = 4}"),
            "not so many whole numbers from 10 to 12"},
        Bad{"RangeFromList", vary("lower_layer.poisson = {from = [0.1], to = 0.3, points = 2}"),
            "from = [0.1]: must be one value"},
        Bad{"RangeKeyUnknown", vary("load.tangential_ratio = {from = 0.1, to = 0.3, step = 1}"),
            "unknown key vary.load.tangential_ratio.step; a range has"},
        Bad{"RangeOfWords", vary("load.press = {from = 0.1, to = 0.3, points = 2}"),
            "has no range"},
        Bad{"ScaleUnknown",
            vary("load.tangential_ratio = {from = 0.1, to = 0.3, points = 2, scale = \"lag\"}"),
            "did you mean \"log\"?"},
        Bad{"LogFromZero",
            vary("load.tangential_ratio = {from = 0, to = 0.3, points = 2, scale = \"log\"}"),
            "must be greater than 0 on a logarithmic scale"},
        Bad{"SampleMissing", vary("load.tangential_ratio = {from = 0.1, to = 0.3}"),
            "has no points; give points = 5, or a section [latin_hypercube]"},
        Bad{"SampleOfNothing", head + "[latin_hypercube]\npoints = 5", "samples nothing"},
        Bad{"SampleWithoutPoints",
            vary("load.tangential_ratio = {from = 0.1, to = 0.3}\n[latin_hypercube]\nseed = 5"),
            "missing key latin_hypercube.points"},
        Bad{"SetAndVaried",
            head + "[set]\nload.tangential_ratio = 0.1\n[vary]\nload.tangential_ratio = [0.2]",
            "load.tangential_ratio = 0.1: is varied too"},
        Bad{"SetBad", head + "[set]\nload.tangential_ratio = 2", "study.toml:3:25: load"},
        Bad{"ModelsVaried", vary("models = [\"mdr\"]"), "write models = [...] at the top"},
        Bad{"OutputVaried", vary("output.vtk = [\"all\"]"), "changes no number"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(StudyOfWalkingMachines, HasTheKeysOfItsCase) {
    const std::string walking =
        "case = \"" + paths::source("examples/cases/walking_set_b.toml") + "\"\n";
    const Study study =
        parse(walking + "[set]\ntime.end = 100\n[vary]\nmachine.kappa8 = [0, 1.18]\n");
    EXPECT_TRUE(study.walks);
    EXPECT_TRUE(study.models.empty());
    EXPECT_EQ(table_heading(*study.axes.front().key), "machine.kappa8");
    EXPECT_FALSE(parse(head + "[vary]\nload.tangential_ratio = [0.1]\n").walks);
    EXPECT_EQ(message_of(walking + "[vary]\nload.tangential_ratio = [0.1]\n"),
              "study.toml:3:6: unknown key vary.load.tangential_ratio: the case has no key "
              "load.tangential_ratio; docs/reference/walking.md lists the keys");
    EXPECT_EQ(message_of("levels = 2\n" + walking + "[vary]\nmachine.kappa8 = [0]\n"),
              "study.toml:1:1: a walking case has no levels; omit the key");
}

}  // namespace
}  // namespace tricontact::io::study_reader_test

#include "comparisons/reproduction/reproduction.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace tricontact::comparisons::reproduction_test {
namespace {

constexpr double tolerance = 1e-6;

const std::string summary = R"x({
  "version": "1",
  "models": {"mdr": {"final_shift_m": 2e-4, "static_shift_m": 1e-4, "cpu_s": 1.0,
                     "list": [0.0, 0.5], "state": "shakedown",
                     "audit": {"worst": 1e-5, "allowed": 1e-4}}},
  "numerical_error": {"model": "mdr", "half_widths": {"final_shift_m": 1e-6}}
})x";

std::string with(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

Reproduction changed(const std::string& from, const std::string& to) {
    return compare_with_kept({{"summary.json", summary}},
                             {{"summary.json", with(summary, from, to)}}, tolerance);
}

TEST(Reproduction, TheSameNumbersAreTheSameBytes) {
    const auto r = changed("1.0", "1.0");
    EXPECT_TRUE(r.same_bytes() && r.reproduces());
    EXPECT_EQ(r.n_numbers, 7U);  // without the time
    EXPECT_EQ(reproduction_text(r), "same bytes: 7 numbers in 1 files\n");
}

TEST(Reproduction, VersionAndTimesDoNotCount) {
    EXPECT_TRUE(changed("\"cpu_s\": 1.0", "\"cpu_s\": 2.0").same_bytes());
    EXPECT_TRUE(changed("\"version\": \"1\"", "\"version\": \"2\"").same_bytes());
}

TEST(Reproduction, ANumberOffIsToldWithItsPlace) {
    const auto r = changed("\"static_shift_m\": 1e-4", "\"static_shift_m\": 1.01e-4");
    EXPECT_FALSE(r.reproduces());
    ASSERT_EQ(r.changed.size(), 1U);
    EXPECT_EQ(r.changed[0].quantity, "models/mdr/static_shift_m");
    EXPECT_NEAR(r.changed[0].difference, 0.01, 1e-12);  // rounding of the subtraction
    const std::string text = reproduction_text(r);
    EXPECT_NE(text.find("differs summary.json: models/mdr/static_shift_m: 1.00e-02 relative"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("not reproduced"), std::string::npos);
}

TEST(Reproduction, StatedErrorsAndToleranceCount) {
    // Half a percent is half of the stated error, 1e-6 m.
    EXPECT_TRUE(changed("\"final_shift_m\": 2e-4", "\"final_shift_m\": 2.005e-4").reproduces());
    EXPECT_FALSE(changed("\"final_shift_m\": 2e-4", "\"final_shift_m\": 2.011e-4").reproduces());
    EXPECT_TRUE(
        changed("\"static_shift_m\": 1e-4", "\"static_shift_m\": 1.0000005e-4").reproduces());
    EXPECT_TRUE(changed("\"worst\": 1e-5", "\"worst\": 9e-5").reproduces());
    EXPECT_FALSE(changed("\"worst\": 1e-5", "\"worst\": 2e-4").reproduces());
    // Rounding beside other numbers of a list.
    EXPECT_TRUE(changed("[0.0, 0.5]", "[1e-17, 0.5]").reproduces());
    EXPECT_FALSE(changed("[0.0, 0.5]", "[1e-5, 0.5]").reproduces());
}

TEST(Reproduction, WordsHaveToBeTheSame) {
    const auto r = changed("shakedown", "ratcheting");
    ASSERT_EQ(r.otherwise.size(), 1U);
    EXPECT_EQ(r.otherwise[0],
              "summary.json: models/mdr/state: \"shakedown\" was kept, now it is \"ratcheting\"");
    EXPECT_FALSE(r.reproduces());
    EXPECT_FALSE(changed("2e-4", "null").reproduces());
    EXPECT_FALSE(changed("\"list\": [0.0, 0.5]", "\"list\": [0.0]").reproduces());
    EXPECT_FALSE(changed("\"static_shift_m\"", "\"static_shift_mm\"").reproduces());
}

TEST(Reproduction, FilesAreOnBothSides) {
    EXPECT_FALSE(compare_with_kept({{"a.csv", "x\n1\n"}}, {}, tolerance).reproduces());
    EXPECT_FALSE(compare_with_kept({}, {{"a.csv", "x\n1\n"}}, tolerance).reproduces());
    EXPECT_THROW(compare_with_kept({{"a.json", "{"}}, {{"a.json", "{"}}, tolerance),
                 std::runtime_error);
}

TEST(Reproduction, TablesAreComparedByColumns) {
    const std::string csv = "x [mm],u [1],± u [1]\n1,0.5,0.1\n2,1,0.1\n\nstrip,begin\nstick,3\n";
    const auto compared = [&](const std::string& from, const std::string& to) {
        return compare_with_kept({{"a.csv", csv}}, {{"a.csv", with(csv, from, to)}}, tolerance);
    };
    EXPECT_TRUE(compared("1,0.5,0.1", "1,0.55,0.1").reproduces());  // stated: 0.1
    const auto r = compared("2,1,0.1", "2,1.2,0.1");
    EXPECT_FALSE(r.reproduces());
    ASSERT_EQ(r.changed.size(), 1U);
    EXPECT_EQ(r.changed[0].place, "line 3, u [1]");
    const auto strip = compared("stick,3", "stick,4");
    ASSERT_EQ(strip.changed.size(), 1U);
    EXPECT_EQ(strip.changed[0].place, "line 6, begin");
    EXPECT_FALSE(compared("stick,3", "slip,3").reproduces());
    EXPECT_FALSE(compared("u [1]", "v [1]").reproduces());
    const auto quoted = numbers_in("b.csv", "\"a, \"\"b\"\"\",c\n1,2\n");
    ASSERT_EQ(quoted.size(), 4U);
    EXPECT_EQ(quoted[2].quantity, "a, \"b\"");
}

TEST(Reproduction, AsJson) {
    const auto json = reproduction_json(changed("1e-4", "2e-4"));
    EXPECT_EQ(json["reproduces"], false);
    EXPECT_EQ(json["changed"][0]["values"], 1);
}

}  // namespace
}  // namespace tricontact::comparisons::reproduction_test

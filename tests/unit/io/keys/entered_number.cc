#include <gtest/gtest.h>

#include "contact/base/error.h"
#include "io/keys/number_text.h"
#include "io/keys/toml_document.h"
#include "io/keys/uncertain_number.h"
#include "io/tables/csv_table.h"

namespace tricontact::io::entered_number_test {
namespace {

struct Typed {
    const char* text;
    double value;
};

// What people type, and what they mean: no rounding, so exactly.
constexpr Typed fractions[] = {{".24", .24},    {"24e-2", .24}, {"+.5", .5},       {"-.5", -.5},
                               {"5.", 5},       {"+1.5", 1.5},  {"1.5E3", 1500},   {"00.5", .5},
                               {"2.5e-1", .25}, {".5e1", 5},    {"1e-300", 1e-300}};
constexpr Typed whole[] = {{"+1", 1}, {"007", 7}, {"1e4", 10000}, {"-3", -3}, {"2E+3", 2000}};

TEST(EnteredNumber, FractionsAreDoubles) {
    for (const auto& [text, value] : fractions) {
        const Value typed = parse_value(text);
        ASSERT_TRUE(std::holds_alternative<double>(typed)) << text;
        EXPECT_EQ(std::get<double>(typed), value) << text;
    }
}

TEST(EnteredNumber, WholeNumbersFitKeysThatCount) {
    for (const auto& [text, value] : whole) {
        const Value typed = parse_value(text);
        ASSERT_TRUE(std::holds_alternative<std::int64_t>(typed)) << text;
        EXPECT_EQ(std::get<std::int64_t>(typed), value) << text;
    }
}

TEST(EnteredNumber, ListsToo) {
    EXPECT_EQ(std::get<std::vector<double>>(parse_value("[.24, +1 , 5.]")),
              (std::vector<double>{.24, 1, 5}));
}

TEST(EnteredNumber, TextsStayTexts) {
    for (const char* text : {"", "+", "-", ".", "e5", "1,5", "1.2.3", "--1", "+-1", "1e", "40 mm",
                             "5.2MPa", "[.24, mm]", "v1.5"})
        EXPECT_FALSE(entered_number(text)) << text;
    // TOML has these, and keeps them.
    EXPECT_EQ(std::get<std::int64_t>(parse_value("1_000")), 1000);
    EXPECT_TRUE(std::holds_alternative<double>(parse_value("inf")));
}

TEST(EnteredNumber, WholeOnlyWhereDoublesAre) {
    EXPECT_TRUE(std::holds_alternative<double>(parse_value("1e300")));
    EXPECT_TRUE(std::holds_alternative<double>(parse_value("9007199254740993.")));
}

TEST(EnteredNumber, APlusStandsInTablesAndMeasuredValues) {
    const auto q = parse_uncertain_number("+1.55 ± +.13", Dimension::none);
    EXPECT_EQ(q.value.value, 1.55);
    EXPECT_EQ(q.value.standard_error, .13);
    EXPECT_EQ(parse_uncertain_number("+.5 mm", Dimension::length).half_digit, .05e-3);
    const CsvTable table("a\n+1\n.24\n5.\n+2e-1\n", "table", {"table", "a", 10, "thin", 1});
    EXPECT_EQ(table.values("a", Dimension::none), (std::vector<double>{1, .24, 5, .2}));
    EXPECT_FALSE(number_in("+-1"));
}

TEST(EnteredNumber, FilesAreToldHowTomlWritesIt) {
    const auto message = [](const char* text) -> std::string {
        try {
            parse_document(text, "a.toml");
        } catch (const contact::InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_NE(message("# x = .5\n[rolling]\namplitude_ratio = .24\n")
                  .find("write a digit on both sides of the point, as in 0.24"),
              std::string::npos);
    EXPECT_EQ(message("a = [1, 2\n# .5\n").find("both sides"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::io::entered_number_test

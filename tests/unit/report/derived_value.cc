// Numbers that follow from a case: units that fit for people, SI as data.

#include "report/derived_value.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tricontact::derived_value_test {
namespace {

TEST(DerivedValue, TextHasTheUnitThatFitsAndFourDigits) {
    EXPECT_EQ(report::derived_lines({{"d", 0.000506904, "m", "indentation"},
                                     {"F_T", 0, "N", "tangential force"},
                                     {"w", 0.24, "1", "W/a"}}),
              "# d        =        506.9 µm   indentation\n"
              "# F_T      =            0 N    tangential force\n"
              "# w        =       0.2400 -    W/a\n");
}

TEST(DerivedValue, DataHaveAllDigitsInSi) {
    const double value = 0.00050690412345678901;
    const auto json = report::derived_json({{"d", value, "m", "indentation"}});
    EXPECT_EQ(json["d"]["value"].get<double>(), value);
    EXPECT_EQ(json["d"]["unit"], "m");
    EXPECT_EQ(nlohmann::json::parse(json.dump())["d"]["value"].get<double>(), value);
}

}  // namespace
}  // namespace tricontact::derived_value_test

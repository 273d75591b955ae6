#include "comparisons/resolution/verification.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace tricontact::comparisons::verification_test {
namespace {

/// Errors 0.16, 0.04, 0.01 at sizes halved twice: second order.
VerificationRow second_order() {
    return {.problem = "Hertz",
            .quantity = "a, mm",
            .model = "bem",
            .source = "Hertz (1882)",
            .reference = 2,
            .tolerance = .011,
            .sizes = {.4, .2, .1},
            .values = {2.32, 2.08, 2.02}};
}

TEST(Verification, ErrorOrderAndVerdictOfARow) {
    VerificationRow row = second_order();
    EXPECT_NEAR(row.error(0), .16, 1e-12);
    EXPECT_NEAR(row.error(2), .01, 1e-12);
    EXPECT_NEAR(row.order().value(), 2, 1e-10);
    EXPECT_TRUE(row.passed());
    row.least_order = 1.9;
    EXPECT_TRUE(row.passed());
    row.least_order = 2.1;
    EXPECT_FALSE(row.passed());
    row.least_order = 0;
    row.values.front() = 2.001;  // smaller by chance
    EXPECT_TRUE(row.passed());
    row.tolerance = .009;
    EXPECT_FALSE(row.passed());
    row.values.back() = 2;  // exact: no order can be seen
    EXPECT_FALSE(row.order());
}

TEST(Verification, OneLevelHasNoOrder) {
    VerificationRow row = second_order();
    row.sizes = {.1};
    row.values = {2.02};
    EXPECT_FALSE(row.order());
    EXPECT_TRUE(row.passed());
}

TEST(Verification, OneRowThatFailsFailsAll) {
    Verification all{.rows = {second_order(), second_order()}};
    EXPECT_TRUE(all.passed());
    EXPECT_EQ(verification_markdown(all).find("FAIL"), std::string::npos);
    all.rows.back().tolerance = 1e-3;
    EXPECT_FALSE(all.passed());
    EXPECT_NE(verification_markdown(all).find("| 1.0e-03 | 2.0 | **FAIL** |"), std::string::npos);
    EXPECT_FALSE(verification_json("0", all)["passed"].get<bool>());
}

TEST(Verification, SourcesAreListedOnce) {
    Verification all{.rows = {second_order(), second_order()}};
    all.rows.push_back(second_order());
    all.rows.back().source = "Another (1900)";
    const std::string text = verification_markdown(all);
    EXPECT_NE(text.find("1. Hertz (1882)\n2. Another (1900)\n"), std::string::npos);
    EXPECT_EQ(text.find("3. "), std::string::npos);
}

}  // namespace
}  // namespace tricontact::comparisons::verification_test

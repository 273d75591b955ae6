// The section [tractive_rolling]; what it refuses stands in tests/cli/bad.

#include <gtest/gtest.h>

#include <numbers>

#include "io/case/case_reader.h"
#include "tests/unit/io/sphere_case.h"

namespace tricontact::io::tractive_rolling_test {
namespace {

using contact::Case;

Case rolling_on(const std::string& load, const std::string& rolling) {
    return parse_case(pressed_sphere + load + "\n[tractive_rolling]\n" + rolling, "rolling.toml");
}

TEST(TractiveRolling, DrivenByForce) {
    const Case c = rolling_on("tangential_ratio = 0.56", "");
    ASSERT_TRUE(c.tractive_rolling);
    EXPECT_FALSE(c.rolling);
    EXPECT_FALSE(c.tractive_rolling->longitudinal_creepage);
    EXPECT_FALSE(c.tractive_rolling->lateral_creepage);
    EXPECT_EQ(c.tractive_rolling->spin, 0);
    EXPECT_EQ(c.tractive_rolling->distance, 8);
}

TEST(TractiveRolling, DrivenByCreepage) {
    const Case c = rolling_on("", R"(longitudinal_creepage = -0.002
lateral_creepage = 0.001
spin = "45 deg/m"
distance = 3.5)");
    EXPECT_FALSE(c.load.tangential_ratio || c.load.tangential_force);
    EXPECT_EQ(c.tractive_rolling->longitudinal_creepage, -.002);
    EXPECT_EQ(c.tractive_rolling->lateral_creepage, .001);
    EXPECT_NEAR(c.tractive_rolling->spin, std::numbers::pi / 4, 1e-15);
    EXPECT_EQ(c.tractive_rolling->distance, 3.5);
}

TEST(TractiveRolling, WrittenAndReadAgainItIsTheSame) {
    const Case c = rolling_on("", "longitudinal_creepage = 1e-3\nspin = \"0.3 rad/m\"");
    const std::string text = write_case(c);
    const Case again = parse_case(text, "again.toml");
    EXPECT_EQ(again.tractive_rolling->longitudinal_creepage, 1e-3);
    EXPECT_FALSE(again.tractive_rolling->lateral_creepage);
    EXPECT_EQ(again.tractive_rolling->spin, .3);
    EXPECT_EQ(write_case(again), text);
}

TEST(TractiveRolling, FrictionFallsWithTheSpeedOfSlip) {
    const Case c = rolling_on("", R"(longitudinal_creepage = 1e-3
speed = "2 m/s"
[friction.rate]
law = "linear"
drops = 0.1
speeds = "50 mm/s")");
    ASSERT_TRUE(c.friction.rate);
    EXPECT_EQ(c.tractive_rolling->distance, 0);
    EXPECT_EQ(c.friction.rate->drops, std::vector{.1});
    EXPECT_EQ(c.friction.rate->memory_length, 0);
    const std::string text = write_case(c);
    EXPECT_EQ(text.find("distance"), std::string::npos);
    const Case again = parse_case(text, "again.toml");
    EXPECT_EQ(again.friction.rate->speeds, std::vector{.05});
    EXPECT_EQ(again.tractive_rolling->speed, 2);
    EXPECT_EQ(write_case(again), text);
}

TEST(TractiveRolling, HasASpeedWhereTheSubstrateRelaxes) {
    EXPECT_EQ(rolling_on("tangential_ratio = 0.56", "").tractive_rolling->speed, 0);
    const Case c = rolling_on("tangential_ratio = 0.56", R"(speed = "20 mm/s"
[substrate.relaxation]
G2 = "1 MPa"
eta = "20 kPa s")");
    EXPECT_EQ(c.tractive_rolling->speed, .02);
    ASSERT_TRUE(c.relaxation);
    EXPECT_EQ(parse_case(write_case(c), "again.toml").tractive_rolling->speed, .02);
}

}  // namespace
}  // namespace tricontact::io::tractive_rolling_test

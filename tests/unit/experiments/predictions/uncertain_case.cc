#include "experiments/predictions/uncertain_case.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/error.h"
#include "io/case/case_keys.h"

namespace tricontact::uncertain_case_test {
namespace {

using contact::Case;
using experiments::steepest_direction;
using experiments::UncertainCase;

constexpr double friction = .6, normal_force = 20;

Case rig() {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5e6, .5};
    c.friction.coefficient = friction;
    c.load.normal_force = normal_force;
    c.load.tangential_ratio = .5;
    return c;
}

io::UncertainKey uncertain(const char* path, double error) {
    return {.key = io::find_key(path), .number = {.value = {0, error}}, .place = "a.toml:1:1"};
}

// Of independent numbers the gradient over errors, of length one.
TEST(SteepestDirection, IsTheGradient) {
    const auto direction = steepest_direction({3, -4}, {});
    ASSERT_EQ(direction.size(), 2U);
    EXPECT_DOUBLE_EQ(direction[0], .6);
    EXPECT_DOUBLE_EQ(direction[1], -.8);
    EXPECT_TRUE(steepest_direction({0, 0}, {}).empty());
}

// Two numbers that are one, by their correlation, move together by an error each.
TEST(SteepestDirection, FollowsCorrelations) {
    const auto direction = steepest_direction({1, 1}, {{1, 1}, {1, 1}});
    EXPECT_DOUBLE_EQ(direction[0], 1);
    EXPECT_DOUBLE_EQ(direction[1], 1);
}

// The rig sets a force: the error of f_T is that of F_T = f_T mu F_N.
TEST(UncertainCase, PassesTheErrorOfARatioToItsForce) {
    const UncertainCase uncertain_rig = experiments::uncertain_case(
        rig(), friction * normal_force, 0, {uncertain("load.tangential_ratio", .02)});
    ASSERT_EQ(uncertain_rig.quantities.size(), 1U);
    EXPECT_DOUBLE_EQ(uncertain_rig.quantities[0].standard_error, .02 * friction * normal_force);
    EXPECT_DOUBLE_EQ(*uncertain_rig.set.load.tangential_force, .5 * friction * normal_force);
    EXPECT_EQ(uncertain_rig.names(), (std::vector<std::string>{"load.tangential_ratio"}));
}

TEST(UncertainCase, RefusesWhatTheCaseDoesNotState) {
    try {
        experiments::uncertain_case(rig(), normal_force, 0,
                                    {uncertain("substrate.thickness", 1e-4)});
        FAIL() << "not refused";
    } catch (const contact::InputError& why) {
        EXPECT_TRUE(std::string(why.what()).starts_with("a.toml:1:1: substrate.thickness"))
            << why.what();
    }
}

// Off by errors along the direction; beyond the end of a range mirrored there: nu <= 1/2.
TEST(UncertainCase, IsDisplacedByErrors) {
    const UncertainCase uncertain_rig = experiments::uncertain_case(
        rig(), normal_force, 0,
        {uncertain("substrate.young", 1e5), uncertain("substrate.poisson", .01)});
    const Case moved = experiments::displaced(uncertain_rig, {.6, .8}, 2);
    EXPECT_NEAR(moved.substrate.young, 5e6 + 1.2e5, 1);
    EXPECT_NEAR(moved.substrate.poisson, .5 - .016, 1e-9);
}

}  // namespace
}  // namespace tricontact::uncertain_case_test

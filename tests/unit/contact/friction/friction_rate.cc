// Friction that falls with the speed of slip.

#include "contact/friction/friction_rate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/friction/friction.h"

namespace tricontact::friction_rate_test {
namespace {

using contact::FrictionRate;
using Law = FrictionRate::Law;

constexpr Law laws[] = {Law::linear, Law::rational, Law::exponential};
constexpr double rounding = 1e-14;

TEST(FrictionRate, HalfIsLostAtTheSpeedOfEachPart) {
    for (const Law law : laws) {
        const FrictionRate rate{law, {.12}, {.1}};
        EXPECT_NEAR(rate.coefficient(.3, 0), .3, rounding);
        EXPECT_NEAR(rate.coefficient(.3, .1), .24, rounding);
        EXPECT_NEAR(rate.coefficient(.3, 1e12), .18, 1e-12);
        EXPECT_NEAR(rate.least(.3), .18, rounding);
    }
}

// At three times the speed of a half: nothing is left of a line, 1/4 and 1/10 of both quotients,
// 1/8 of the exponential.
TEST(FrictionRate, EachLawFallsItsWay) {
    EXPECT_NEAR((FrictionRate{Law::linear, {.12}, {.1}}.coefficient(.3, .3)), .18, rounding);
    EXPECT_NEAR((FrictionRate{Law::rational, {.06, .06}, {.1, .1}}.coefficient(.3, .3)),
                .18 + .06 / 4 + .06 / 10, rounding);
    EXPECT_NEAR((FrictionRate{Law::exponential, {.12}, {.1}}.coefficient(.3, .3)), .18 + .12 / 8,
                rounding);
}

// Sliding by d_c in many steps leaves 1/e of the old coefficient; at rest v_0 heals.
TEST(FrictionRate, MemoryFadesWithTheWay) {
    const FrictionRate rate{Law::exponential, {.12}, {.1}, 3e-6, 1e-3};
    double left = 1;
    constexpr int steps = 10000;
    for (int k = 0; k < steps; ++k) left *= rate.memory(3e-6 / .5 / steps, .5);
    EXPECT_NEAR(left, std::exp(-1), 1e-4);  // implicit steps are of the first order
    EXPECT_NEAR(rate.memory(3e-3, 0), .5, rounding);
    EXPECT_EQ((FrictionRate{Law::linear, {.12}, {.1}}.memory(1, .5)), 0);
}

// Whatever asks for Coulomb's law is not answered by one that is it at rest alone.
TEST(FrictionRate, IsNoCoulombFriction) {
    contact::Friction friction{.3};
    EXPECT_TRUE(friction.is_coulomb());
    friction.rate = FrictionRate{Law::exponential, {.12}, {.1}};
    EXPECT_FALSE(friction.is_coulomb());
    EXPECT_EQ(friction.law()->coulomb(), .3);
    EXPECT_EQ(friction.formula(),
              "0.3 p at rest, falling by 0.12 p (half of it at 0.1 m/s), exponentially");
}

}  // namespace
}  // namespace tricontact::friction_rate_test

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "contact/verdict.h"

namespace tricontact {
namespace {

using contact::State;

/// A history of `n` periods from the static shift .2 with the given increments; the work dissipated
/// goes with the increment, mu F_N U_max f Du with f = .5.
State verdict(int n, const std::function<double(int)>& increment) {
    std::vector<double> shift, dissipation;
    double u = .2;
    for (int k = 1; k <= n; ++k) {
        u += increment(k);
        shift.push_back(u);
        dissipation.push_back(.5 * std::abs(increment(k)));
    }
    return contact::judge({.2, shift, dissipation});
}

// A shift that stays where it is tells nothing while friction still works: settled is below both
// 1e-7 of U_max and 1e-6 of mu F_N U_max a period (contact/verdict.h).
TEST(Verdict, IsNotSettledWhileFrictionWorks) {
    const auto settled = [](double increment, double dissipation) {
        return contact::has_settled({.2, {.3, .3 + increment}, {.1, dissipation}});
    };
    EXPECT_TRUE(settled(0, 9e-7));
    EXPECT_FALSE(settled(0, 2e-6));
    EXPECT_FALSE(settled(0, -2e-6));
    EXPECT_TRUE(settled(9e-8, 0));
    EXPECT_FALSE(settled(2e-7, 0));
    EXPECT_FALSE(settled(-2e-7, 0));
}

TEST(Verdict, NothingIsKnownBeforeTheFourthPeriod) {
    for (int n = 0; n < 4; ++n)
        EXPECT_EQ(verdict(n, [](int) { return .1; }), State::undecided) << n;
}

TEST(Verdict, GeometricDecayShakesDown) {
    for (const double ratio : {.05, .3, .6, .9}) {
        auto decay = [ratio](int k) { return .1 * std::pow(ratio, k); };
        // enough periods that less than 1e-3 is to come
        const int n = 4 + static_cast<int>(std::log(1e-3 * (1 - ratio)) / std::log(ratio));
        EXPECT_EQ(verdict(n, decay), State::shakedown) << ratio;
        EXPECT_EQ(verdict(4 * n, decay), State::shakedown) << ratio;
    }
    // 0.9^12 leaves .25: not yet
    EXPECT_EQ(verdict(12, [](int k) { return .1 * std::pow(.9, k); }), State::undecided);
}

TEST(Verdict, ConstantIncrementsRatchet) {
    for (const double step : {1e-5, .04, 2.})
        for (const int n : {4, 12, 60})
            EXPECT_EQ(verdict(n, [&](int) { return step; }), State::ratcheting);
}

TEST(Verdict, ConstantAfterATransientRatchets) {
    auto increment = [](int k) { return .1 + .3 * std::pow(.7, k); };
    // Its constant part is .58 of the fourth increment, and .85 of the eighth.
    EXPECT_EQ(verdict(4, increment), State::undecided);
    EXPECT_EQ(verdict(8, increment), State::ratcheting);
    EXPECT_EQ(verdict(60, increment), State::ratcheting);
    // The transient may also come from below, as just beyond the limit it does not.
    EXPECT_EQ(verdict(8, [](int k) { return .1 - .05 * std::pow(.7, k); }), State::ratcheting);
}

TEST(Verdict, SmallConstantUnderALargeTransientIsNotTakenForShakedown) {
    auto increment = [](int k) { return 2e-4 + .3 * std::pow(.7, k); };
    for (int n = 4; n < 20; ++n) EXPECT_NE(verdict(n, increment), State::ratcheting) << n;
    for (int n = 18; n < 100; ++n) EXPECT_NE(verdict(n, increment), State::shakedown) << n;
    EXPECT_EQ(verdict(40, increment), State::ratcheting);
}

TEST(Verdict, AtTheLimitNobodyKnows) {
    // The increments decay like 1/n^2, by the same sum as any ratcheting would in 60 periods.
    for (const int n : {12, 30, 60, 100, 1000})
        EXPECT_EQ(verdict(n, [](int k) { return .5 / (k * k); }), State::undecided) << n;
    // So slow a decay cannot be told from a constant within some periods.
    for (const int n : {12, 30})
        EXPECT_EQ(verdict(n, [](int k) { return 2e-3 * std::pow(.97, k); }), State::undecided) << n;
}

TEST(Verdict, NoiseOfTheSolverDoesNotMatter) {
    auto noise = [](int k) { return std::sin(17. * k * k); };
    auto ratcheting = [&](int k) { return .05 * (1 + 1e-3 * noise(k)); };
    auto settling = [&](int k) { return .1 * std::pow(.8, k) + 1e-8 * noise(k); };
    for (int n = 8; n < 60; ++n) EXPECT_EQ(verdict(n, ratcheting), State::ratcheting) << n;
    for (int n = 28; n < 60; ++n) EXPECT_EQ(verdict(n, settling), State::shakedown) << n;
    // noise alone, below what counts
    EXPECT_EQ(verdict(12, [&](int k) { return 5e-8 * noise(k); }), State::shakedown);
    // noise above it, without direction
    EXPECT_EQ(verdict(13, [&](int k) { return k % 2 ? 1e-3 : -1e-3; }), State::undecided);
}

TEST(Verdict, DirectionDoesNotMatter) {
    EXPECT_EQ(verdict(12, [](int) { return -.1; }), State::ratcheting);
    EXPECT_EQ(verdict(12, [](int k) { return -.1 * std::pow(.3, k); }), State::shakedown);
    EXPECT_EQ(verdict(12, [](int k) { return -.1 * std::pow(.9, k); }), State::undecided);
}

TEST(Verdict, SlippingToAndFroIsNoShakedown) {
    const std::vector<double> shift(12, .3), dissipation(12, .01), none(12, 0.);
    EXPECT_FALSE(contact::has_settled({.3, shift, dissipation}));
    EXPECT_EQ(contact::judge({.3, shift, dissipation}), State::undecided);
    EXPECT_TRUE(contact::has_settled({.3, shift, none}));
    EXPECT_EQ(contact::judge({.3, shift, none}), State::shakedown);
}

TEST(Verdict, LastIncrement) {
    EXPECT_EQ(contact::last_increment({.2, {}, {}}), 0);
    EXPECT_NEAR(contact::last_increment({.2, {.25}, {0.}}), .05, 1e-16);
    EXPECT_NEAR(contact::last_increment({.2, {.5, .4}, {0., 0.}}), .1, 1e-16);
    EXPECT_FALSE(contact::has_settled({.2, {}, {}}));
}

TEST(Verdict, Names) {
    EXPECT_STREQ(contact::name_of(State::shakedown), "shakedown");
    EXPECT_STREQ(contact::name_of(State::ratcheting), "ratcheting");
    EXPECT_STREQ(contact::name_of(State::undecided), "undecided");
}

}  // namespace
}  // namespace tricontact

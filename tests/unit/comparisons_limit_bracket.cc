#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/limit_bracket.h"
#include "comparisons/rolled_periods.h"

namespace tricontact::comparisons {
namespace {

using contact::State;

/// Shakes down below `first`, ratchets above `last`, cannot be decided in between.
std::function<State(double)> with_band(double first, double last) {
    return [=](double value) {
        return value < first ? State::shakedown
                             : (value > last ? State::ratcheting : State::undecided);
    };
}

TEST(LimitBracket, BisectsToTheTolerance) {
    for (const double limit : {.001, .3, .51, .73, .9999}) {
        const LimitBracket found = find_limit(with_band(limit, limit), 0, 1, 1e-6);
        EXPECT_LE(found.last_shakedown, limit);
        EXPECT_GE(found.first_ratcheting, limit);
        EXPECT_LE(found.first_ratcheting - found.last_shakedown, 1e-6);
        EXPECT_LE(found.probes.size(), 21u) << limit;  // 2^-20 < 1e-6
        EXPECT_LE(std::abs(found.centre() - limit), found.half_width() * (1 + 1e-9));
    }
}

TEST(LimitBracket, LeavesWhatCannotBeDecidedInsideAndCountsIt) {
    const double first = .41, last = .47;
    const LimitBracket found = find_limit(with_band(first, last), 0, 1, 1e-3);
    ASSERT_TRUE(found.undecided);
    EXPECT_LE(found.last_shakedown, first);
    EXPECT_GE(found.first_ratcheting, last);
    EXPECT_LE(found.undecided->first - found.last_shakedown, 1e-3);
    EXPECT_LE(found.first_ratcheting - found.undecided->second, 1e-3);
    EXPECT_GE(found.undecided->first, first);
    EXPECT_LE(found.undecided->second, last);
}

TEST(LimitBracket, BandNarrowerThanTheToleranceIsPassedOver) {
    const LimitBracket found = find_limit(with_band(.4999, .5002), 0, 1, 1e-2);
    EXPECT_LE(found.last_shakedown, .4999);
    EXPECT_GE(found.first_ratcheting, .5002);
    EXPECT_LE(found.first_ratcheting - found.last_shakedown, 2e-2 + 3e-4);
}

TEST(LimitBracket, EndsWhereNothingCanBeDecided) {
    const LimitBracket found = find_limit([](double) { return State::undecided; }, 0, 1, 1e-2);
    EXPECT_EQ(found.last_shakedown, 0);
    EXPECT_EQ(found.first_ratcheting, 1);
    EXPECT_LE(found.undecided->first, 1e-2);
    EXPECT_GE(found.undecided->second, 1 - 1e-2);
    EXPECT_LT(found.probes.size(), 20u);
}

std::vector<RolledPeriod> periods(int n, bool sticks, double first, double ratio, double rest) {
    std::vector<RolledPeriod> result;
    for (int i = 0; i < n; ++i) result.push_back({first * std::pow(ratio, i) + rest, sticks});
    return result;
}

TEST(Fate, NothingSticksAndIncrementsStay) {
    EXPECT_EQ(fate(periods(12, false, .1, .3, .2), 1e-5), State::ratcheting);
    // As long as a point sticks, the longest series of equal increments proves nothing.
    EXPECT_EQ(fate(periods(200, true, 0, 1, .2), 1e-5), State::undecided);
}

TEST(Fate, SlowDecayIsNoRatcheting) {
    // Everything slips by a little, the increments fall by 0.3 % per period.
    for (const int n : {20, 100, 500})
        EXPECT_EQ(fate(periods(n, false, 1e-3, .997, 0), 1e-5), State::undecided) << n;
    // At the limit itself they fall as 1/n^2.
    std::vector<RolledPeriod> at_limit;
    for (int n = 1; n < 300; ++n) at_limit.push_back({1. / (n * n), false});
    EXPECT_EQ(fate(at_limit, 1e-9), State::undecided);
}

TEST(Fate, SettledOnlyWhereSomethingSticks) {
    EXPECT_EQ(fate(periods(12, true, .1, .3, 0), 1e-5), State::shakedown);
    EXPECT_EQ(fate(periods(12, false, .1, .3, 0), 1e-5), State::undecided);
    EXPECT_EQ(fate(periods(4, true, .1, .3, 0), 1e-5), State::undecided);
    EXPECT_EQ(fate({}, 1e-5), State::undecided);
}

TEST(Fate, PassingTheNarrowPlace) {
    // Increments of u' = e + u^2 from u = -1 to 0 and on: shrinking, then growing again.
    std::vector<RolledPeriod> all;
    double u = -1;
    const double e = 1e-4;
    bool ratchets = false;
    while (u < 1 && !ratchets) {
        const double step = .1 * (e + u * u);
        all.push_back({step, u < 0});
        u += step;
        ratchets = fate(all, 1e-8) == State::ratcheting;
        if (ratchets) {
            EXPECT_GT(u, 0);
        }
    }
    EXPECT_TRUE(ratchets);
}

}  // namespace
}  // namespace tricontact::comparisons

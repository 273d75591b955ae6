#include "comparisons/shakedown/limit_bracket.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tricontact::comparisons::limit_bracket_test {
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
        unsigned n = 0;
        const auto counted = [&](double value) {
            ++n;
            return with_band(limit, limit)(value);
        };
        const LimitBracket found = find_limit(counted, 0, 1, 1e-6);
        EXPECT_LE(found.last_shakedown, limit);
        EXPECT_GE(found.first_ratcheting, limit);
        EXPECT_LE(found.first_ratcheting - found.last_shakedown, 1e-6);
        EXPECT_LE(n, 21u) << limit;  // 2^-20 < 1e-6
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
    unsigned n = 0;
    const auto undecided = [&](double) {
        ++n;
        return State::undecided;
    };
    const LimitBracket found = find_limit(undecided, 0, 1, 1e-2);
    EXPECT_EQ(found.last_shakedown, 0);
    EXPECT_EQ(found.first_ratcheting, 1);
    EXPECT_LE(found.undecided->first, 1e-2);
    EXPECT_GE(found.undecided->second, 1 - 1e-2);
    EXPECT_LT(n, 20u);
}

}  // namespace
}  // namespace tricontact::comparisons::limit_bracket_test

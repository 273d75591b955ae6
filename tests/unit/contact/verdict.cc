#include "contact/verdict.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace tricontact::verdict_test {
namespace {

using contact::Judge;
using contact::Judged;
using contact::RolledPeriod;
using contact::State;

using Series = std::function<RolledPeriod(int)>;  // of the period n = 1, 2, ...

Judge after(int n, const Series& series, const Judged& judged = {}) {
    Judge judge(judged);
    for (int k = 1; k <= n; ++k) judge.add(series(k));
    return judge;
}

/// Under F_T = mu F_N / 2, which does all the work, that of the increment.
Series shifts(const std::function<double(int)>& increment, bool something_sticks) {
    return [=](int n) {
        return RolledPeriod{increment(n), .5 * std::abs(increment(n)), something_sticks};
    };
}

Series holding(const std::function<double(int)>& increment) {
    return shifts(increment, true);
}
Series loose(const std::function<double(int)>& increment) {
    return shifts(increment, false);
}

std::function<double(int)> geometric(double first, double ratio) {
    return [=](int n) { return first * std::pow(ratio, n - 1); };
}

/// The states after N, 2N and 4N periods, for N = 1 to 50: what is decided stays decided.
void expect_no_change_of_mind(const Series& series, const Judged& judged = {}) {
    Judge judge(judged);
    State decided = State::undecided;
    for (int n = 1; n <= 200; ++n) {
        judge.add(series(n));
        if (decided != State::undecided) {
            ASSERT_EQ(judge.state(), decided) << n;
        }
        decided = judge.state();
    }
}

TEST(Verdict, ShakedownIsWhatNeitherMovesNorWorks) {
    // .1 * .3^(n-1) comes below 1e-7 with n = 13, and its work below 1e-6 before that.
    EXPECT_EQ(after(12, holding(geometric(.1, .3))).state(), State::undecided);
    EXPECT_EQ(after(13, holding(geometric(.1, .3))).state(), State::shakedown);
    EXPECT_EQ(after(100, holding(geometric(.1, .3))).state(), State::shakedown);
    EXPECT_EQ(after(13, holding(geometric(-.1, .3))).state(), State::shakedown);
    // MDR rests exactly, within one period.
    EXPECT_EQ(after(1, holding([](int) { return 0; })).state(), State::shakedown);
}

TEST(Verdict, NothingIsShakenDownThatNothingHolds) {
    EXPECT_EQ(after(50, loose(geometric(.1, .3))).state(), State::undecided);
    EXPECT_EQ(after(50, loose([](int) { return 1e-9; })).state(), State::undecided);
    EXPECT_TRUE(std::isinf(after(50, loose([](int) { return 1e-9; })).verdict().remaining_error));
    // Without a load there is nothing to be held.
    const Judged unloaded{.has_load = false};
    EXPECT_EQ(after(3, loose([](int) { return 0; }), unloaded).state(), State::shakedown);
}

TEST(Verdict, CyclicSlipWorksTheSameWhileTheShiftStands) {
    const auto slips = [](int n) {
        return RolledPeriod{.1 * std::pow(.1, n), 1e-3 * (1 + std::pow(.5, n)), true};
    };
    // Within 1 % over four periods from .5^7 on; the increments below 1e-7 from n = 6 on.
    EXPECT_EQ(after(9, slips).state(), State::undecided);
    EXPECT_EQ(after(10, slips).state(), State::cyclic_slip);
    EXPECT_EQ(after(400, slips).state(), State::cyclic_slip);
    // Work that decays, if as 1/sqrt(n) only, is not for ever.
    const auto dies = [](int n) { return RolledPeriod{0, 1e-3 / std::sqrt(n), true}; };
    for (const int n : {4, 16, 64, 256}) EXPECT_EQ(after(n, dies).state(), State::undecided) << n;
    // The least that counts is the caller's.
    const auto little = [](int) { return RolledPeriod{0, 5e-6, true}; };
    EXPECT_EQ(after(8, little).state(), State::cyclic_slip);
    EXPECT_EQ(after(8, little, {.negligible_work = 1e-5}).state(), State::shakedown);
}

TEST(Verdict, ConstantIncrementsRatchetIfNothingHolds) {
    for (const double step : {1e-5, .04, 2., 1e4, -.1}) {
        const auto constant = [=](int) { return step; };
        EXPECT_EQ(after(4, loose(constant)).state(), State::undecided);
        for (const int n : {5, 12, 60})
            EXPECT_EQ(after(n, loose(constant)).state(), State::ratcheting) << step;
        EXPECT_EQ(after(200, holding(constant)).state(), State::undecided) << step;
    }
}

TEST(Verdict, ConstantAfterATransientRatchets) {
    const auto increment = [](int n) { return .1 + .3 * std::pow(.7, n); };
    EXPECT_EQ(after(5, loose(increment)).state(), State::undecided);
    EXPECT_EQ(after(20, loose(increment)).state(), State::ratcheting);
    const auto from_below = [](int n) { return .1 - .05 * std::pow(.7, n); };
    EXPECT_EQ(after(8, loose(from_below)).state(), State::ratcheting);
    expect_no_change_of_mind(loose([](int n) { return 2e-4 + .3 * std::pow(.7, n); }));
}

TEST(Verdict, SlowDecayIsNoRatcheting) {
    // All that is still to come is less than U_max: the contact may rest.
    for (const double ratio : {.95, .99, .997, .9999})
        for (const int n : {12, 30, 100, 1000})
            EXPECT_EQ(after(n, loose(geometric(1 - ratio, ratio))).state(), State::undecided)
                << ratio << ' ' << n;
    // At the limit increments decay as 1/n^2.
    for (const int n : {12, 60, 1000})
        EXPECT_EQ(after(n, loose([](int k) { return .5 / (k * k); })).state(), State::undecided);
}

TEST(Verdict, PassingTheNarrowPlaceBeyondTheLimit) {
    // Increments of u' = e + u^2 from u = -1 to 0 and on: shrinking, then growing again.
    Judge judge({.negligible_shift = 1e-8});
    double u = -1;
    while (u < 1 && judge.state() == State::undecided) {
        const double step = .1 * (1e-4 + u * u);
        judge.add({step, step, u < 0});
        u += step;
    }
    EXPECT_EQ(judge.state(), State::ratcheting);
    EXPECT_GT(u, 0);
}

TEST(Verdict, ToAndFroIsNoRatcheting) {
    EXPECT_EQ(after(60, loose([](int n) { return n % 2 ? 1e-3 : -1e-3; })).state(),
              State::undecided);
    // A state of two periods that gets on, by .01 to .03, would have to stop from .01.
    EXPECT_EQ(after(60, loose([](int n) { return n % 2 ? .1 : .09; })).state(), State::ratcheting);
}

TEST(Verdict, TheLimitDecidesAtOnceAndBeyondItsAccuracy) {
    const auto with_limit = [](double f, double limit) {
        Judge judge({.tangential_ratio = f, .limit_accuracy = 1e-6});
        judge.set_limit(limit);
        judge.add({.1, .05, true});
        return judge.verdict();
    };
    EXPECT_EQ(with_limit(.3, .31).state, State::shakedown);
    EXPECT_EQ(with_limit(.3, .29).state, State::ratcheting);
    EXPECT_TRUE(with_limit(.3, .29).by_limit);
    EXPECT_EQ(with_limit(.3, .3 + 5e-7).state, State::undecided);
    EXPECT_FALSE(with_limit(.3, .3 + 5e-7).by_limit);
    Judge coupled((Judged()));
    coupled.set_limit(.1);
    EXPECT_EQ(coupled.state(), State::undecided);
}

TEST(Verdict, WhoRelaxesIsJudgedWhenTheFirstPeriodsAreForgotten) {
    const auto rests = holding([](int) { return 0; });
    EXPECT_EQ(after(29, rests, {.memory = 29.5}).state(), State::undecided);
    EXPECT_FALSE(after(29, rests, {.memory = 29.5}).has_settled());
    EXPECT_EQ(after(30, rests, {.memory = 29.5}).state(), State::shakedown);
    EXPECT_TRUE(after(30, rests, {.memory = 29.5}).has_settled());
}

TEST(Verdict, MorePeriodsAreAskedForWhereTheyHelp) {
    const std::string more = "raise rolling.periods", finer = "lower it";
    const auto missing = [](int n, const Series& series) {
        return after(n, series).verdict().missing;
    };
    const auto says = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(says(missing(5, holding(geometric(.1, .9))), more));
    EXPECT_TRUE(says(missing(5, loose(geometric(.1, .9))), more));
    EXPECT_TRUE(says(missing(5, [](int n) { return RolledPeriod{0, .1 / n, true}; }), more));
    EXPECT_TRUE(says(missing(50, loose([](int) { return 1e-9; })), finer));
    EXPECT_TRUE(says(missing(100, holding([](int) { return .1; })), finer));
    EXPECT_EQ(missing(50, holding(geometric(.1, .1))), "");
}

// Exact for q^n; for n^-p as n grows; what is just below the limit begins as the one and ends as
// the other.
TEST(StillToCome, HoldsWhatComes) {
    const auto check = [](const std::function<double(int)>& x, int n, int all) {
        std::vector<double> series;
        for (int k = 1; k <= n; ++k) series.push_back(x(k));
        double rest = 0;
        for (int k = all; k > n; --k) rest += x(k);
        const contact::Bounded said = contact::still_to_come(series, 1e-12);
        EXPECT_NEAR(said.value, rest, said.error) << n;
        EXPECT_GT(said.error, 0);
        return said;
    };
    for (const double ratio : {.05, .3, .9, .99})
        for (const int n : {5, 8, 30}) {
            const auto said = check(geometric(.1, ratio), n, 4000);
            // .1 * .05^30 is below the noise.
            if (ratio > .1) {
                EXPECT_LT(said.error, .11 * said.value + 1e-11) << ratio << ' ' << n;
            }
        }
    for (const double power : {1.5, 2., 3.})
        for (const int n : {12, 40, 200})
            check([=](int k) { return .5 * std::pow(k, -power); }, n, 4000000);
    // Increments of u' = -e + u^2, u < 0, to u = -sqrt(e).
    std::vector<double> series;
    for (double u = -1; series.size() < 3000;) {
        const double step = .1 * (u * u - 1e-3);
        series.push_back(step);
        u += step;
    }
    for (const int n : {5, 10, 20, 50, 100, 300, 1000})
        check([&](int k) { return series.at(k - 1); }, n, 3000);
}

TEST(StillToCome, IsUnknownOfWhatDoesNotDecay) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(contact::still_to_come({}, 1e-7).error, infinity);
    EXPECT_EQ(contact::still_to_come(std::vector{.1, .01, .001, .0001}, 1e-7).error, infinity);
    EXPECT_EQ(contact::still_to_come(std::vector<double>(20, .1), 1e-7).error, infinity);
    EXPECT_EQ(contact::still_to_come(std::vector{.1, -.1, .1, -.1, .1, -.1}, 1e-7).error, infinity);
    EXPECT_EQ(contact::still_to_come(std::vector<double>(20, 0.), 1e-7).error, 1e-7);
}

TEST(Verdict, WhatIsKnownEndsARun) {
    // .1 * .5^(n-1) leaves as much as it added last, of which a tenth is not known.
    Judge judge({.tangential_ratio = .3});
    judge.set_limit(.5);
    int n = 0;
    while (!judge.is_known() && n < 50) judge.add(holding(geometric(.1, .5))(++n));
    EXPECT_EQ(n, 8);
    EXPECT_NEAR(judge.verdict().remaining, .1 * std::pow(.5, 7), judge.verdict().remaining_error);
    Judge ratcheting({.tangential_ratio = .6});
    ratcheting.set_limit(.5);
    const auto increment = [](int k) { return .1 + .1 * std::pow(.5, k); };
    for (n = 0; !ratcheting.is_known() && n < 50;) ratcheting.add(loose(increment)(++n));
    EXPECT_LT(n, 12);
    EXPECT_NEAR(increment(n), .1, .01 * increment(n));
}

/// Whatever the series: sums of decays, of a constant and of noise, some of it without hold.
RC_GTEST_PROP(Verdict, WhatIsDecidedStaysDecided, ()) {
    std::mt19937_64 random(*rc::gen::arbitrary<unsigned>());
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double first = std::pow(10, uniform(-6, 0)), slow = std::pow(10, uniform(-6, -1));
    const double ratio = uniform(.05, .9), slow_ratio = uniform(.5, .999);
    const double constant = uniform(0, 1) < .5 ? 0 : std::pow(10, uniform(-9, 1));
    const double cyclic = uniform(0, 1) < .5 ? 0 : std::pow(10, uniform(-8, 0));
    const double noise = std::pow(10, uniform(-12, -8));
    std::vector<RolledPeriod> all;
    for (int n = 1; n <= 200; ++n) {
        const double decay =
            first * std::pow(ratio, n) + slow * (1 - slow_ratio) * std::pow(slow_ratio, n);
        const double step = decay + constant + uniform(-noise, noise);
        all.push_back({step, std::abs(step) + cyclic * (1 + 1e-3 * uniform(-1, 1)), constant == 0});
    }
    State decided = State::undecided;
    Judge judge((Judged()));
    for (const RolledPeriod& period : all) {
        judge.add(period);
        RC_ASSERT(decided == State::undecided || judge.state() == decided);
        decided = judge.state();
    }
    // And is true.
    RC_ASSERT((decided == State::ratcheting) <= (constant > 0));
    RC_ASSERT(contact::settles(decided) <= (constant == 0));
    if (decided == State::cyclic_slip) RC_ASSERT(cyclic > .99e-6);
    if (decided == State::shakedown) RC_ASSERT(cyclic < 1.01e-6);
}

TEST(Verdict, OfAnInterval) {
    EXPECT_EQ(contact::state_of(-1, .5, 1), State::shakedown);
    EXPECT_EQ(contact::state_of(.5, 2, 1), State::ratcheting);
    EXPECT_EQ(contact::state_of(-1, 2, 1), State::undecided);
    EXPECT_EQ(contact::state_of(NAN, NAN, 0), State::undecided);
}

TEST(Verdict, Names) {
    EXPECT_STREQ(contact::name_of(State::shakedown), "shakedown");
    EXPECT_STREQ(contact::name_of(State::cyclic_slip), "cyclic-slip");
    EXPECT_STREQ(contact::name_of(State::ratcheting), "ratcheting");
    EXPECT_STREQ(contact::name_of(State::undecided), "undecided");
}

}  // namespace
}  // namespace tricontact::verdict_test

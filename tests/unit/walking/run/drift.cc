#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/walking/sets.h"
#include "walking/run/walk_judge.h"
#include "walking/run/walk_recorder.h"

namespace tricontact::walking::drift_test {
namespace {

// U_max of set B: mu kappa2 z_stat = mu kappa4/2.
double unit_shift() {
    return set_b().kappa5 * set_b().kappa4 / 2;
}

template <class Shift>
WalkResult judged(Shift shift, double airborne = 0) {
    std::vector<ExcitedPeriod> periods;
    for (int i = 1; i <= 40; ++i) periods.push_back({shift(i) * unit_shift(), airborne});
    WalkResult result;
    judge_drift({.kappas = set_b()}, periods, result);
    return result;
}

TEST(Drift, NamesWhatAnExcitedMachineDoes) {
    const auto even = [](int i) { return 0.3 * i; };
    EXPECT_EQ(judged(even).regime, Regime::ratcheting);
    EXPECT_NEAR(judged(even).drift->per_period, 0.3, 1e-12);
    EXPECT_LT(judged(even).drift->error, 1e-12);
    EXPECT_EQ(judged(even, 0.1).regime, Regime::walking);
    EXPECT_NEAR(judged(even, 0.1).drift->airborne, 0.1, 1e-12);
    const auto settling = [](int i) { return 1 - std::exp(-i / 4.); };
    EXPECT_EQ(judged(settling).regime, Regime::shakedown);
    EXPECT_TRUE(judged(settling).transient_over);
    // Undamped vibrations, however they fall, are no drift.
    for (int phase = 0; phase < 20; ++phase) {
        const auto vibrating = [&](int i) { return 0.05 * std::sin(2.3 * i + phase); };
        EXPECT_EQ(judged(vibrating).regime, Regime::shakedown) << phase;
    }
}

// An even drift but for one period of the judged 20, off by 0.1. Were both ends off by as much, the
// drift would be by 2 * 0.1/20.
TEST(Drift, ErrorIsThatOfBothEnds) {
    const auto drift = *judged([](int i) { return 0.3 * i + (i == 30 ? 0.1 : 0); }).drift;
    EXPECT_NEAR(drift.per_period, 0.3, 1e-12);
    EXPECT_NEAR(drift.error, 0.01, 1e-12);
}

TEST(Drift, IsNotJudgedFromAFewPeriods) {
    WalkResult result;
    judge_drift({.kappas = set_b()}, {{1e-5}, {2e-5}, {3e-5}, {4e-5}, {5e-5}}, result);
    EXPECT_FALSE(result.drift);
    EXPECT_EQ(result.regime, Regime::steady);
}

TEST(Drift, PeriodsEndWithTheExcitation) {
    Machine machine{.kappas = set_b()};
    machine.kappas.kappa6 = 0;
    machine.excitation.frequency = 2 * std::numbers::pi;  // period 1
    Motion motion{.spots = {{1}, {1}}};
    constexpr double dt = 0.0125;
    WalkRecorder recorder(machine, motion, dt, 1000);
    for (int step = 1; step <= 200; ++step) {
        motion.time = step * dt;  // 80 steps a period, two and a half periods
        motion.x = motion.time;
        motion.phi = 1;
        motion.spots[1].normal = step % 80 < 20 ? 0 : 1;
        recorder.add(motion, std::vector<SpotStep>(2));
    }
    ASSERT_EQ(recorder.periods().size(), 2u);
    EXPECT_NEAR(recorder.periods()[1].shift, 3, 1e-12);
    EXPECT_NEAR(recorder.periods()[1].airborne, 0.25, 1e-12);
}

// The leading spot carries more under a pull, but the least loads of both add up to what is left.
TEST(Drift, LimitsOfQuasiStaticRocking) {
    Machine machine{.kappas = set_b()};
    machine.excitation.moment = 1e-5;
    const DriftLimits limits = drift_limits(machine, 0.4);
    EXPECT_NEAR(limits.ratcheting, 0.6, 1e-15);
    EXPECT_NEAR(limits.lift_off, 1 - 0.4 * 0.68 * 0.5 * (1 + 1.18), 1e-15);
    machine.excitation = {.force = 1e-5};
    EXPECT_EQ(drift_limits(machine, 0.4).lift_off, 1);
}

}  // namespace
}  // namespace tricontact::walking::drift_test

#include "walking/run/walk_judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/unit/statistics/autoregressive.h"
#include "tests/unit/walking/sets.h"

namespace tricontact::walking::walk_judge_test {
namespace {

const Machine machine{.kappas = set_b()};

// Windows of 20 whose z swings between these multiples of the static displacement.
class Windows {
  public:
    void add(double z_min, double z_max, double mu_e = 1, double length = 20) {
        WalkWindow window;
        window.begin = time_;
        window.end = time_ += length;
        StretchSums& sums = window.sums;
        sums.steps = 1000;
        sums.spring_force = 1000 * mu_e * sliding_force(machine);
        const double rest = static_displacement(machine);
        sums.z_min = z_min * rest;
        sums.z_max = z_max * rest;
        sums.phi_min = -1e-5;
        sums.phi_max = 1e-5;
        sums.spots.resize(2);
        for (SpotSums& spot : sums.spots) {
            spot.velocity = 1000 * machine.kappas.kappa6 * slides_;
            spot.sticking = slides_ > 0 ? 0 : 1000;
        }
        windows_.push_back(window);
    }
    // From here on the spots slide with this share of the base's velocity.
    void slide(double share) { slides_ = share; }

    WalkResult judged() const { return judge(machine, {1e-3, windows_, {}, {}}); }
    bool may_repeat() const { return walking::may_repeat(machine, windows_); }

  private:
    double time_ = 0, slides_ = 1;
    std::vector<WalkWindow> windows_;
};

TEST(WalkJudge, ForgetsWhatCameBeforeSteadySliding) {
    Windows windows;
    for (int i = 0; i < 30; ++i) windows.add(-1, 3, 0.3);
    for (int i = 0; i < 30; ++i) windows.add(0.999, 1.001);
    const WalkResult result = windows.judged();
    EXPECT_EQ(result.regime, Regime::steady);
    EXPECT_TRUE(result.transient_over);
    EXPECT_EQ(result.transient, 600);
    EXPECT_EQ(result.observed, 600);
    EXPECT_NEAR(result.mu_e, 1, 1e-12);
}

// Flutter begins small.
TEST(WalkJudge, AVibrationThatGrowsIsNotOver) {
    Windows windows;
    for (int i = 0; i < 50; ++i) {
        const double amplitude = 1e-6 * std::exp(i / 10.);
        windows.add(1 - amplitude, 1 + amplitude);
    }
    const WalkResult result = windows.judged();
    EXPECT_EQ(result.regime, Regime::steady);
    EXPECT_FALSE(result.transient_over);
}

// The mean of a swing that goes on for n windows is off by what one window is, over n.
TEST(WalkJudge, TheErrorOfASwingFallsWithTime) {
    Windows windows;
    for (int i = 0; i < 100; ++i) windows.add(1, 1, i % 2 ? 1.01 : 0.99);
    EXPECT_NEAR(windows.judged().mu_e_error, 0.01 / 100, 1e-12);
}

// The base moves, the spots stick: a load, which no friction has answered yet.
TEST(WalkJudge, ALoadIsNoFriction) {
    Windows windows;
    windows.slide(0);
    for (int i = 0; i < 100; ++i) windows.add(1, 1, 0.001 * i);
    const WalkResult result = windows.judged();
    EXPECT_EQ(result.regime, Regime::sticking);
    EXPECT_FALSE(result.transient_over);
    EXPECT_TRUE(std::isnan(result.mu_e));
    EXPECT_TRUE(std::isnan(result.mu_e_error));
}

// Loading that takes half of the run counts neither in the mean nor in the error.
TEST(WalkJudge, LoadingIsTransient) {
    Windows windows;
    windows.slide(0);
    for (int i = 0; i < 50; ++i) windows.add(1, 1, i / 50.);
    windows.slide(1);
    for (int i = 0; i < 50; ++i) windows.add(1, 1, i % 2 ? 0.99 : 1.01);
    const WalkResult result = windows.judged();
    EXPECT_EQ(result.regime, Regime::steady);
    EXPECT_TRUE(result.transient_over);
    EXPECT_EQ(result.transient, 1000);
    EXPECT_NEAR(result.mu_e, 1, 1e-12);
    EXPECT_NEAR(result.mu_e_error, 0.01 / 50, 1e-12);
}

// What still comes is told by the error: all of the way to sliding.
TEST(WalkJudge, AForceThatRisesIsNotOver) {
    for (const double slides : {1., 0.5}) {
        Windows rising, level;
        rising.slide(slides), level.slide(slides);
        for (int i = 0; i < 100; ++i) {
            rising.add(1, 1, 0.4 + 0.002 * i + (i % 2 ? 0.01 : 0));
            level.add(1, 1, 0.4 + (i % 2 ? 0.01 : 0));
        }
        EXPECT_FALSE(rising.judged().transient_over);
        EXPECT_GE(rising.judged().mu_e + rising.judged().mu_e_error, 1);
        // A force without a trend does not tell either while the spots lag behind the base.
        EXPECT_EQ(level.judged().transient_over, slides == 1);
    }
}

// A run that turns back has the same mean in its first and last third: its second half tells.
TEST(WalkJudge, AForceThatTurnsIsNotOver) {
    Windows windows;
    for (int i = 0; i < 100; ++i) windows.add(1, 1, 0.9 + std::pow(i / 50. - 1, 2) / 100);
    EXPECT_FALSE(windows.judged().transient_over);
}

// z is free while all spots stay on the ground. In the air it is not, however evenly it swings.
TEST(WalkJudge, AnEvenSwingThatLeavesTheGroundIsNotSteady) {
    Windows pressed, jumping;
    for (int i = 0; i < 50; ++i) {
        pressed.add(0.6, 1.4);
        jumping.add(-0.1, 2.1);
    }
    EXPECT_EQ(pressed.judged().regime, Regime::steady);
    EXPECT_NE(jumping.judged().regime, Regime::steady);
}

// |phi| of each window is distributed exponentially: one in exp(1/scale) falls. Twelve thousand
// windows, in which 6 of scale 1/8 and 0.3 in a million of scale 1/24 are to be expected.
TEST(WalkJudge, ExpectsTheFallsOfAnExponentialTail) {
    std::mt19937_64 generator(1);
    const auto expected = [&](double scale) {
        std::exponential_distribution<double> rotation(1 / scale);
        std::vector<WalkWindow> windows(1200);
        for (WalkWindow& window : windows) {
            window.sums.phi_max = std::min(rotation(generator), 0.99) * tilting_limit(machine);
            window.sums.phi_min = 0;
        }
        return expected_falls(machine, windows, 10);
    };
    // The mean of 600 excesses is known to 4 %; times 8, the exponent to 0.33.
    EXPECT_NEAR(std::log(expected(1. / 8) / (12000 * std::exp(-8.))), 0, 3 * 0.33);
    EXPECT_LT(expected(1. / 24), 1e-4);
    // A rotation that drifts is at the limit after three more of these runs.
    std::vector<WalkWindow> drifting(120);
    for (std::size_t i = 0; i < drifting.size(); ++i)
        drifting[i].sums.phi_max = drifting[i].sums.phi_min =
            (0.1 + 0.002 * static_cast<double>(i)) * tilting_limit(machine);
    EXPECT_EQ(expected_falls(machine, drifting, 10), std::numeric_limits<double>::infinity());
    EXPECT_LT(expected_falls(machine, drifting, 1), 1);
}

// By hand, with rotations of either sign: the median of 8 windows is 0.2 of the limit, the mean of
// the four above it 0.35. 4 exp(-(1 - 0.2)/0.15) falls in the time of the windows.
TEST(WalkJudge, FallsToEitherSideAreExpectedAlike) {
    std::vector<WalkWindow> windows;
    int side = 1;
    for (const double rotation : {0.1, 0.5, 0.2, 0.1, 0.1, 0.4, 0.3, 0.1}) {
        WalkWindow& window = windows.emplace_back();
        window.sums.phi_min = window.sums.phi_max = 0;
        (side > 0 ? window.sums.phi_max : window.sums.phi_min) =
            side * rotation * tilting_limit(machine);
        side = -side;
    }
    EXPECT_NEAR(expected_falls(machine, windows, 10) / (40 * std::exp(-0.8 / 0.15)), 1, 1e-12);
}

// A body that swings freely at v takes up to 2 v of momentum from the spring in a stretch, and
// gives it back in another: mean forces of the first and the last third differ by 4 v over their
// time, and no trend is in it. Ten times that is one.
TEST(WalkJudge, WhatASwingCarriesIsNoTrend) {
    const double v = 5 * machine.kappas.kappa6, length = 20;
    const auto evenly = [&](double momentum) {
        std::vector<WalkWindow> windows;
        for (const int side : {1, 1, 0, 0, -1, -1}) {
            WalkWindow& window = windows.emplace_back();
            window.end = (window.begin = length * static_cast<double>(windows.size())) + length;
            window.sums.steps = 1000;
            window.sums.spring_force = 1000 * (sliding_force(machine) + side * momentum / length);
            // x' = kappa6 + v sin(omega t)
            window.sums.kinetic_energy =
                1000 * (std::pow(machine.kappas.kappa6, 2) + v * v / 2) / 2;
            window.sums.spots.resize(2);
        }
        return is_evenly_pulled(machine, windows);
    };
    EXPECT_TRUE(evenly(v));  // 2 v in the two windows of a third
    EXPECT_FALSE(evenly(10 * v));
}

TEST(WalkJudge, ChaosCountsWhenItHasLastedLong) {
    std::mt19937_64 generator(1);
    const auto noise = statistics::autoregressive(0, 200, generator);
    Windows brief, lasting;
    for (const double value : noise) {
        brief.add(-3, 4, 0.5 + 0.1 * value, 20);
        lasting.add(-3, 4, 0.5 + 0.1 * value, 100);
    }
    EXPECT_EQ(brief.judged().regime, Regime::chaotic);
    EXPECT_FALSE(brief.judged().transient_over);
    EXPECT_GT(brief.judged().mu_e_error, 0.2);  // as far as any of 200 normal values
    const WalkResult result = lasting.judged();
    EXPECT_EQ(result.regime, Regime::chaotic);
    EXPECT_TRUE(result.transient_over);
    // One series tells its own error to some 15 %: its variance, its correlation, its resamples.
    EXPECT_NEAR(result.mu_e_error / (1.96 * 0.1 / std::sqrt(200)), 1, 0.3);
    // A start under another force is left out, of the mean and of its error.
    Windows late;
    for (int i = 0; i < 20; ++i) late.add(-3, 4, 2, 100);
    for (const double value : noise) late.add(-3, 4, 0.5 + 0.1 * value, 100);
    EXPECT_EQ(late.judged().transient, 2000);
    EXPECT_EQ(late.judged().mu_e_error, result.mu_e_error);
}

TEST(WalkJudge, ChaosThatChangesItsWaysIsNotOver) {
    std::mt19937_64 generator(1);
    Windows windows;
    int i = 0;
    for (const double value : statistics::autoregressive(0, 200, generator))
        windows.add(-3, 4, (i++ < 140 ? 1 : 0.7) + 0.05 * value, 100);
    EXPECT_FALSE(windows.judged().transient_over);
    EXPECT_GT(windows.judged().mu_e_error, 0.2);
}

TEST(WalkJudge, ReturnsAreOfUseWhereExtremesRepeat) {
    Windows cycle, chaos, sliding;
    for (int i = 0; i < 50; ++i) {
        cycle.add(-0.4289, 2.3545);
        chaos.add(-3 - 0.1 * (i % 7) * (i % 3), 4);
        sliding.add(0.999, 1.001);
    }
    EXPECT_TRUE(cycle.may_repeat());
    EXPECT_FALSE(chaos.may_repeat());
    EXPECT_FALSE(sliding.may_repeat());
}

}  // namespace
}  // namespace tricontact::walking::walk_judge_test

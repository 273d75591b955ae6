#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "dynamics/walk_judge.h"
#include "dynamics_autoregressive.h"
#include "dynamics_sets.h"

namespace tricontact::dynamics {
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
        windows_.push_back(window);
    }

    WalkResult judged() const { return judge(machine, {1e-3, windows_, {}, {}}); }
    bool may_repeat() const { return dynamics::may_repeat(machine, windows_); }

  private:
    double time_ = 0;
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

TEST(WalkJudge, ChaosCountsWhenItHasLastedLong) {
    std::mt19937_64 generator(1);
    const auto noise = autoregressive(0, 200, generator);
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
}

TEST(WalkJudge, ChaosThatChangesItsWaysIsNotOver) {
    std::mt19937_64 generator(1);
    Windows windows;
    int i = 0;
    for (const double value : autoregressive(0, 200, generator))
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
}  // namespace tricontact::dynamics

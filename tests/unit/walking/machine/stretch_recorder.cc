#include "walking/machine/stretch_recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/walking/sets.h"
#include "walking/run/walk_recorder.h"

namespace tricontact::walking::stretch_recorder_test {
namespace {

constexpr double speed = 2e-4, sway = 1.5e-4, load = 3e-4, swing = 2e-4;

// A spot that moves at speed + sway cos t under a normal deflection load + swing cos(t - lag).
Motion swaying(double t, double lag) {
    Motion motion{.time = t, .x = speed * t + sway * std::sin(t), .z = load + swing * std::cos(t)};
    motion.x_velocity = speed + sway * std::cos(t);
    motion.z_velocity = -swing * std::sin(t);
    motion.spots.push_back({.normal = load + swing * std::cos(t - lag)});
    return motion;
}

StretchSums sums_of_a_period(double lag, int n_steps) {
    const double step = 2 * std::numbers::pi / n_steps;
    StretchRecorder recorder({.kappas = set_b()}, swaying(-step, lag), step);
    recorder.add(swaying(0, lag), {{.sticks = true}});
    recorder.take();  // what lags a step behind is of this stretch then
    for (int i = 1; i <= n_steps; ++i)
        recorder.add(swaying(i * step, lag), {{.sticks = 4 * i <= n_steps}});
    return recorder.take();
}

// Means over a period of harmonic motions; central differences shorten them by sin(dt)/dt.
TEST(StretchRecorder, HasTheMeansOfHarmonicMotions) {
    constexpr int n = 1000;
    const StretchSums sums = sums_of_a_period(0.4, n);
    EXPECT_EQ(sums.steps, n);
    EXPECT_NEAR(sums.spring_force / n, -set_b().kappa1 * speed * std::numbers::pi * (1 + 1. / n),
                1e-12);
    EXPECT_NEAR(sums.kinetic_energy / n, (speed * speed + sway * sway / 2 + swing * swing / 2) / 2,
                1e-15);
    EXPECT_NEAR(sums.z_max, load + swing, 1e-15);
    EXPECT_NEAR(sums.z_min, load - swing, 1e-15);
    ASSERT_EQ(sums.spots.size(), 1u);
    EXPECT_EQ(sums.spots[0].sticking, n / 4);
    EXPECT_NEAR(sums.spots[0].velocity / n, speed, 1e-12);
    EXPECT_NEAR(sums.spots[0].normal / n, load, 1e-12);
}

// Two cosines correlate by the cosine of their lag.
TEST(StretchRecorder, CorrelatesVelocityAndNormalDeflection) {
    for (const double lag : {0., 0.5, 2., std::numbers::pi}) {
        const StretchSums sums = sums_of_a_period(lag, 1000);
        EXPECT_NEAR(correlation(sums.spots[0], sums.steps), std::cos(lag), 1e-9) << lag;
    }
}

// Two windows of 100 steps; the 50 that are left over lengthen the second one.
TEST(WalkRecorder, WindowsGoOnToTheEndOfTheRun) {
    const auto at = [](int i) { return swaying(0.1 * i, 0); };
    WalkRecorder recorder({.kappas = set_b()}, at(0), 0.1, 100);
    for (int i = 1; i <= 250; ++i) recorder.add(at(i), {{.sticks = true}});
    const std::vector<WalkWindow> windows = recorder.windows();
    ASSERT_EQ(windows.size(), 2u);
    EXPECT_EQ(windows[0].sums.steps, 100);
    EXPECT_EQ(windows[1].sums.steps, 150);
    EXPECT_EQ(windows[1].begin, windows[0].end);
    EXPECT_NEAR(windows[1].begin, 10, 1e-12);
    EXPECT_NEAR(windows[1].end, 25, 1e-12);
}

}  // namespace
}  // namespace tricontact::walking::stretch_recorder_test

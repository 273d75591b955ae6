#include "walking/run/limit_cycle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "tests/unit/walking/sets.h"
#include "walking/run/walk_recorder.h"

namespace tricontact::walking::limit_cycle_test {
namespace {

constexpr double step = 1e-3;

// Returns of the logistic map z -> r z (1 - z), whose cycles are known, 1 unit of time apart.
std::vector<SectionReturn> logistic_returns(double r, int n) {
    std::vector<SectionReturn> returns;
    double z = 0.4;
    for (int i = 0; i < 1000; ++i) z = r * z * (1 - z);
    for (int i = 0; i < n; ++i, z = r * z * (1 - z)) {
        SectionReturn point;
        point.motion.time = i;
        point.motion.z = z;
        point.sums.steps = 1000;
        point.sums.kinetic_energy = 500;  // 1/2 a step: a size of 1
        returns.push_back(point);
    }
    return returns;
}

TEST(LimitCycle, FindsTheCyclesOfTheLogisticMap) {
    const Machine machine{.kappas = set_b()};
    const auto points = [&](double r) {
        const auto returns = logistic_returns(r, 48);
        const auto cycle = find_limit_cycle(machine, returns, step);
        return cycle ? cycle->section_points : 0;
    };
    EXPECT_EQ(points(2.8), 1);
    EXPECT_EQ(points(3.2), 2);
    EXPECT_EQ(points(3.5), 4);
    EXPECT_EQ(points(3.55), 8);
    EXPECT_EQ(points(3.83), 3);
    EXPECT_EQ(points(4.0), 0);  // chaos
    EXPECT_EQ(points(3.7), 0);
}

// Returns within the tolerance of each other, 1e-4: those that creep along by 5e-6 are on no cycle,
// those that come nearer, or scatter about one, are.
TEST(LimitCycle, DoesNotTakeACreepingMotionForACycle) {
    const Machine machine{.kappas = set_b()};
    const auto settled = [&](auto height) {
        auto returns = logistic_returns(2.8, 48);
        for (std::size_t i = 0; i < returns.size(); ++i)
            returns[i].motion.z += height(static_cast<double>(i));
        const auto cycle = find_limit_cycle(machine, returns, step);
        return cycle && cycle->settled;
    };
    EXPECT_FALSE(settled([](double i) { return 5e-6 * i; }));
    EXPECT_TRUE(settled([](double i) { return 5e-5 * std::exp(-i / 10); }));
    EXPECT_TRUE(settled([](double i) { return 2e-5 * std::sin(2.4 * i); }));
    EXPECT_TRUE(settled([](double i) { return 1e-8 * i; }));  // the error of the integration
}

// A body that bounces while its spots stick, or swing on the spot, repeats itself within the
// tolerance if the base is slow enough. One that is dragged goes farther than its returns miss.
TEST(LimitCycle, SlidesFartherThanItsReturnsMiss) {
    const Machine machine{.kappas = set_b()};
    const auto slides = [&](double velocity) {
        auto returns = logistic_returns(2.8, 48);
        for (std::size_t i = 0; i < returns.size(); ++i) {
            returns[i].motion.z += i % 2 ? 1e-5 : 0;
            returns[i].sums.spots.assign(2, {.velocity = 1000 * velocity});
        }
        const auto cycle = find_limit_cycle(machine, returns, step);
        return cycle && cycle->slides;
    };
    EXPECT_FALSE(slides(0));
    EXPECT_FALSE(slides(0.9e-5));
    EXPECT_TRUE(slides(1.1e-5));
}

TEST(LimitCycle, CountsWholePeriodsFromTheEnd) {
    const Machine machine{.kappas = set_b()};
    const auto returns = logistic_returns(3.2, 30);
    const auto cycle = find_limit_cycle(machine, returns, step);
    ASSERT_TRUE(cycle.has_value());
    EXPECT_EQ(cycle->n_periods, 14);  // of 29 intervals
    EXPECT_NEAR(cycle->period, 2, 1e-12);
    EXPECT_EQ(cycle->begin, 1);
    EXPECT_EQ(cycle->sums.steps, 28000);
}

// Where a cycle loses its stability returns come nearer as one over the root of time only: what is
// left of the way is as much as the time has seen.
TEST(LimitCycle, TellsWhatIsLeftOfTheWay) {
    const Machine machine{.kappas = set_b()};
    auto returns = logistic_returns(2.95, 48);  // the multiplier is -0.95
    double z = 2;
    for (SectionReturn& point : returns) {
        z *= 0.95;
        point.sums.spring_force = 1000 * (1 + 1e-5 * z);
        point.motion.z += 1e-5 * z;
    }
    const auto cycle = find_limit_cycle(machine, returns, step);
    ASSERT_TRUE(cycle.has_value());
    EXPECT_GT(cycle->spring_force_drift, 0);
    EXPECT_NEAR(cycle->spring_force, 1, 2 * cycle->spring_force_drift);
}

// Periods of 1 in the first half of the time and of 1.001 in the second: they differ by 0.001.
TEST(LimitCycle, DriftOfThePeriodIsThatOfTheHalves) {
    auto returns = logistic_returns(2.8, 21);
    for (std::size_t i = 11; i < returns.size(); ++i)
        returns[i].motion.time = returns[i - 1].motion.time + 1.001;
    const LimitCycle cycle = mean_cycle({.kappas = set_b()}, returns, 1, step);
    EXPECT_NEAR(cycle.period, 1.0005, 1e-12);
    EXPECT_NEAR(cycle.period_drift, 0.001, 1e-12);
}

TEST(LimitCycle, OfTooFewReturnsIsNone) {
    const auto returns = logistic_returns(2.8, 11);
    EXPECT_FALSE(find_limit_cycle({.kappas = set_b()}, returns, step).has_value());
}

// Swing of the spring about a mean force, over steps that do not divide its period: f_s = k1 (A + B
// cos omega t), sections where x' = kappa6 + B omega sin omega t rises through kappa6.
LimitCycle swinging(double dt) {
    constexpr double mean = 0.3e-4, amplitude = 1.3e-4, omega = 1.37;
    Machine machine{.kappas = set_b()};
    const double kappa6 = machine.kappas.kappa6;
    const auto at = [&](double t) {
        Motion motion{.time = t, .base = kappa6 * t};
        motion.x = motion.base - mean - amplitude * std::cos(omega * t);
        motion.x_velocity = kappa6 + amplitude * omega * std::sin(omega * t);
        motion.spots.resize(2);
        return motion;
    };
    WalkRecorder recorder(machine, at(0.5), dt, 1000000);
    for (int i = 1; 0.5 + i * dt < 100; ++i) recorder.add(at(0.5 + i * dt), {{}, {}});
    const auto cycle = find_limit_cycle(machine, recorder.returns(), dt);
    EXPECT_TRUE(cycle.has_value());
    EXPECT_NEAR(cycle->period, 2 * std::numbers::pi / omega, 1e-2 * dt * dt);
    return *cycle;
}

// The means are over periods, not over the steps that are nearest: second order in the step.
TEST(LimitCycle, AveragesOverPeriodsNotSteps) {
    const double exact = set_b().kappa1 * 0.3e-4, amplitude = set_b().kappa1 * 1.3e-4;
    for (const double dt : {0.03, 0.017, 0.009}) {
        const LimitCycle cycle = swinging(dt);
        EXPECT_NEAR((cycle.spring_force - exact) / amplitude, 0, 0.1 * dt * dt) << dt;
        EXPECT_LT(cycle.spring_force_drift / amplitude, dt * dt) << dt;
    }
}

// Energy of a difference, term by term.
TEST(LimitCycle, DistanceIsInEnergy) {
    const Machine machine{.kappas = set_b()};
    Motion a{.base = 1, .x = 2}, b{.base = 3, .x = 4};
    a.spots.resize(2);
    b.spots.resize(2);
    EXPECT_EQ(distance(machine, a, b), 0);  // carried on by the base
    b.phi_velocity = 2;
    EXPECT_NEAR(distance(machine, a, b), 2 * std::sqrt(0.42) / 0.5, 1e-12);
    b.phi_velocity = 0;
    b.z = 3;
    b.spots[1].tangential = 4;
    EXPECT_NEAR(distance(machine, a, b), 5, 1e-12);
}

}  // namespace
}  // namespace tricontact::walking::limit_cycle_test

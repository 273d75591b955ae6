#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/unit/walking/sets.h"
#include "walking/run/walk.h"
#include "walking/run/walk_judge.h"

namespace tricontact::walking::walk_run_test {
namespace {

const Walk& run_of_set_b() {
    static const Walk run = walk(case_of(set_b(), 5000));
    return run;
}

// Wetter (2016), figure 4.5: slides, z constant. f_s swings on undamped; the mean's error says so.
TEST(WalkRun, SetASlidesSteadily) {
    const WalkResult result = walk(case_of(set_a(), 4000)).result;
    EXPECT_EQ(result.regime, Regime::steady);
    EXPECT_TRUE(result.transient_over);
    EXPECT_NEAR(result.mu_e, 1, 1e-3);
    EXPECT_NEAR(result.mu_e, 1, 2 * result.mu_e_error);
    EXPECT_LT(result.mu_e_error, 1e-3);
    EXPECT_NEAR(result.z_min_ratio, 1, 0.01);
    EXPECT_NEAR(result.z_max_ratio, 1, 0.01);
    EXPECT_FALSE(result.period.has_value());
}

// Its progress rises to the whole, and changes nothing.
TEST(WalkRun, TellsHowFarItIs) {
    std::vector<int> told;
    const Walk watched = walk(case_of(set_a(), 200), {}, [&](int done, int total) {
        EXPECT_EQ(total, 1000);
        told.push_back(done);
    });
    ASSERT_GE(told.size(), 500u);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_EQ(told.back(), 1000);
    EXPECT_EQ(watched.result.mu_e, walk(case_of(set_a(), 200)).result.mu_e);
}

// While both spots stay on the ground z is a free oscillator: what is left of a start is not chaos.
TEST(WalkRun, SlidesSteadilyWithAFreeVibration) {
    WalkCase walk_case = case_of(set_a(), 2000);
    walk_case.start.z = 1.05;
    const WalkResult result = walk(walk_case).result;
    EXPECT_EQ(result.regime, Regime::steady);
    EXPECT_NEAR(result.mu_e, 1, 2 * result.mu_e_error);
    EXPECT_NEAR(result.z_min_ratio + result.z_max_ratio, 2, 0.02);
    EXPECT_GT(result.z_max_ratio, 1.04);
}

TEST(WalkRun, HasNoEffectiveFrictionWithoutFriction) {
    Kappas kappas = set_a();
    kappas.kappa5 = 0;
    const WalkResult result = walk(case_of(kappas, 200)).result;
    EXPECT_TRUE(std::isnan(result.mu_e));
    EXPECT_TRUE(std::isnan(result.mu_e_error));
    EXPECT_EQ(result.spots[0].stick_time, 0);
}

// Without a base that moves nothing does.
TEST(WalkRun, RestsOnItsSpots) {
    Kappas kappas = set_a();
    kappas.kappa6 = 0;
    const WalkResult result = walk(case_of(kappas, 200)).result;
    EXPECT_EQ(result.regime, Regime::steady);
    EXPECT_NEAR(result.mu_e, 0, 1e-12);
    EXPECT_EQ(result.spots[0].stick_time, 1);
    EXPECT_TRUE(std::isnan(result.spots[0].correlation));
}

// Set B with a base that takes 68000 to load the spring, mu kappa4 (1/kappa1 + 1/2)/kappa6, and
// longer, as the body turns: nothing slides by the end.
TEST(WalkRun, DoesNotTellFrictionBeforeItSlides) {
    Kappas kappas = set_b();
    kappas.kappa6 = 1e-9, kappas.kappa8 = 0.2;
    EXPECT_NEAR(loading_time({.kappas = kappas}), 68000, 1e-6);
    const WalkResult result = walk(case_of(kappas, 1000)).result;
    EXPECT_EQ(result.regime, Regime::sticking);
    EXPECT_FALSE(result.transient_over);
    EXPECT_TRUE(std::isnan(result.mu_e));
    EXPECT_EQ(result.spots[0].stick_time, 1);
}

// The same ten times as fast slides before the end, and ends on mu_e = 1; it says so, or that it
// cannot tell, wherever it is stopped.
TEST(WalkRun, TellsTheFrictionOfSlidingOnceItSlides) {
    Kappas kappas = set_b();
    kappas.kappa6 = 1e-7, kappas.kappa8 = 0.2;  // loaded at t = 680 at the earliest
    for (const double end : {300., 800., 1500., 6000.}) {
        const WalkResult result = walk(case_of(kappas, end)).result;
        EXPECT_EQ(result.transient_over, end > 1000) << end;
        if (result.regime == Regime::sticking) continue;
        EXPECT_NEAR(result.mu_e, 1, 1.01 * result.mu_e_error) << end;
    }
}

// A body that bounces while its spring is loaded repeats its motion without being on a cycle.
TEST(WalkRun, ABouncingBodyThatIsLoadedHasNoCycle) {
    WalkCase walk_case = case_of(set_b(), 2000);
    walk_case.machine.kappas.kappa6 = 1e-11;
    walk_case.start.z = 3;
    const WalkResult result = walk(walk_case).result;
    EXPECT_FALSE(result.transient_over) << word_of(result.regime) << ' ' << result.mu_e;
}

// A fast and light machine: f_s swings 160 times as far as friction reaches, with a period that
// windows are nearly as long as. Its momentum is bounded, so that friction is mu kappa4 in the end.
TEST(WalkRun, TheErrorOfSlidingCoversSlowBeats) {
    Kappas kappas{0.1, 1.2, 0.5, 1e-4, 0.2, 0.01, 1.5, 0};
    const WalkResult result = walk(case_of(kappas, 4000)).result;
    EXPECT_EQ(result.regime, Regime::steady);
    EXPECT_NEAR(result.mu_e, 1, result.mu_e_error);
    EXPECT_GT(result.mu_e_error, 0.1);
}

// An independent program's statistics of the cycle of set B, to the digits printed. Chaos of mean
// life 1450 comes before it, different with any other rounding: one in thirty is not over by then.
TEST(WalkRun, SetBWalksOnItsLimitCycle) {
    const WalkResult& result = run_of_set_b().result;
    ASSERT_EQ(result.regime, Regime::limit_cycle);
    EXPECT_TRUE(result.transient_over);
    EXPECT_EQ(result.section_points, 1);
    EXPECT_NEAR(result.transient, 600, 2 * 25);  // to its windows of 25
    EXPECT_NEAR(result.period.value(), 4.2930, 5e-5);
    EXPECT_NEAR(result.mu_e, 0.0440, 5e-5);
    EXPECT_LT(result.mu_e_error, 5e-5);
    EXPECT_NEAR(result.z_min_ratio, -0.4289, 5e-5);
    EXPECT_NEAR(result.z_max_ratio, 2.3545, 1e-4);  // 2.35454
    EXPECT_NEAR(result.phi_min, -3.32e-5, 5e-8);
    EXPECT_NEAR(result.phi_max, 3.12e-5, 5e-8);
    EXPECT_NEAR(result.kinetic_energy, 3.225, 5e-4);
    ASSERT_EQ(result.spots.size(), 2u);
    EXPECT_NEAR(result.spots[0].stick_time, 0.4265, 1e-4);  // a step is 2e-4 of the period
    EXPECT_NEAR(result.spots[1].stick_time, 0.4931, 1e-4);
    EXPECT_NEAR(result.spots[0].correlation, -0.759, 5e-4);
    EXPECT_NEAR(result.spots[1].correlation, -0.727, 5e-4);
    // The phase of a cycle is free, all else is drawn to it.
    ASSERT_TRUE(result.lyapunov.has_value());
    EXPECT_NEAR(result.lyapunov->value, 0, 0.005);
}

// Wetter (2016), figure 4.19: the spots stick about the turning point, then let go, then the body
// jumps.
// Near the stable step, 0.68, set B is chaos of the integration: no step is too coarse to see that.
TEST(WalkRun, ACoarseStepMakesNoLimitCycle) {
    WalkCase walk_case = case_of(set_b(), 5000);
    walk_case.time.step = 0.5;
    EXPECT_EQ(walk(walk_case).result.regime, Regime::chaotic);
}

TEST(WalkRun, SetBHasTheFourPhases) {
    ASSERT_TRUE(run_of_set_b().phases.has_value());
    const WalkPhases& phases = *run_of_set_b().phases;
    EXPECT_LT(phases.sticking, phases.turning_point);
    EXPECT_LT(phases.turning_point, phases.release);
    EXPECT_LT(phases.release, phases.jump);
    EXPECT_LT(phases.jump, phases.landing);
    EXPECT_LT(phases.landing, phases.sticking + phases.period);
    EXPECT_LE(phases.turning_point + phases.period, 5000);
    EXPECT_GT(phases.turning_point + 2 * phases.period, 5000);
    EXPECT_NEAR(phases.jump_height, 0.4289, 5e-5);  // the highest point
    // Each spot sticks in one go, once a period.
    const std::vector<Snapshot>& tail = run_of_set_b().tail;
    const double n_periods = (tail.back().motion.time - tail.front().motion.time) / phases.period;
    for (const std::size_t spot : {0, 1}) {
        int n = 0;
        for (std::size_t i = 1; i < tail.size(); ++i)
            n += tail[i].spots[spot] == SpotState::stick &&
                 tail[i - 1].spots[spot] != SpotState::stick;
        EXPECT_NEAR(n, n_periods, 1);
    }
}

TEST(WalkRun, TooShortSaysSo) {
    const WalkResult result = walk(case_of(set_b(), 300)).result;
    EXPECT_FALSE(result.transient_over);
    EXPECT_NEAR(result.mu_e, 0.0440, 2 * result.mu_e_error);  // where it ends in the end
    ASSERT_TRUE(result.lyapunov.has_value());
    EXPECT_GT(result.lyapunov->value, result.lyapunov->error);  // chaos so far
}

// Its spring force, constant while it slides, would pull it over its leading spot from the start.
TEST(WalkRun, TiltsAboveTheCriticalFriction) {
    Kappas kappas = set_b();
    kappas.kappa5 = 1.2 * critical_friction(kappas);
    const Walk run = walk(case_of(kappas, 4000));
    EXPECT_EQ(run.result.regime, Regime::tilting);
    ASSERT_TRUE(run.result.tilting_time.has_value());
    EXPECT_LT(*run.result.tilting_time, 4000);
    EXPECT_LT(static_cast<double>(run.lane_steps), 4000 / 1e-3);
    EXPECT_NEAR(run.result.phi_min, -0.1 * kappas.kappa3, 1e-4);
    EXPECT_TRUE(std::isnan(run.result.mu_e));
    ASSERT_FALSE(run.tail.empty());  // the fall
    EXPECT_NEAR(run.tail.back().motion.time, *run.result.tilting_time, 0.01);
}

// Stretches add up to the run, whatever they are cut by.
TEST(WalkRun, WindowsCoverTheRun) {
    const Walk run = walk(case_of(set_b(), 100));
    std::int64_t steps = 0;
    double time = 0;
    for (const WalkWindow& window : run.windows) {
        EXPECT_EQ(window.begin, time);
        time = window.end;
        steps += window.sums.steps;
        EXPECT_NEAR(window.end - window.begin, 1e-3 * static_cast<double>(window.sums.steps), 1e-9);
    }
    EXPECT_EQ(steps, run.lane_steps);
    EXPECT_NEAR(time, 100, 1e-9);
    EXPECT_EQ(run.windows.size(), 5u);
}

TEST(WalkRun, RecordsWhatIsAskedFor) {
    const Walk run = walk(case_of(set_b(), 30), {.start = 2, .tail = 10, .interval = 0.02});
    EXPECT_EQ(run.start.size(), 101u);
    EXPECT_EQ(run.start.front().motion.time, 0);
    EXPECT_EQ(run.tail.size(), 501u);
    EXPECT_NEAR(run.tail.back().motion.time, 30, 1e-9);
    for (const Snapshot& snapshot : run.tail)
        for (std::size_t i = 0; i < 2; ++i)
            EXPECT_EQ(snapshot.spots[i] == SpotState::released,
                      snapshot.motion.spots[i].normal == 0);
}

TEST(WalkRun, NeedsAStep) {
    EXPECT_THROW(walk(case_of(set_b(), 1e-4)), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::walking::walk_run_test

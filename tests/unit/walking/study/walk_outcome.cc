#include "walking/study/walk_outcome.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/unit/walking/sets.h"
#include "walking/run/walk.h"

namespace tricontact::walking::walk_outcome_test {
namespace {

WalkCase set_b_case(double end) {
    return {.title = {},
            .machine = {.kappas = walking::set_b()},
            .start = {},
            .time = {.step = 1e-3, .end = end}};
}

// At rest the springs of the spots hold half of what the weight has lost: kappa4 z_stat (1/2 - 1).
TEST(WalkOutcome, EnergyAtRest) {
    EXPECT_NEAR(initial_energy(set_b_case(1).machine, {}), -0.5, 1e-12);
}

// Wetter (2016), eq. 4.2.21, term by term, for a start that has all of them.
TEST(WalkOutcome, EnergyOfAStart) {
    const Kappas k = walking::set_b();
    const double rest = k.kappa4 / (2 * k.kappa2), v = k.kappa6;
    const Start start{.x = -1,
                      .z = 1,
                      .phi = 0.25,
                      .base = 1,
                      .x_velocity = 1,
                      .z_velocity = -1,
                      .phi_velocity = 1};
    const double n1 = rest * (1 + 0.25 / k.kappa3), n2 = rest * (1 - 0.25 / k.kappa3);
    const double stretch = rest * (1 + 1 + 0.25 * k.kappa8);
    const double energy = (k.kappa2 * (n1 * n1 + n2 * n2) + k.kappa1 * stretch * stretch +
                           v * v * (2 + k.kappa7 / (k.kappa3 * k.kappa3))) /
                              2 -
                          k.kappa4 * rest;
    EXPECT_NEAR(initial_energy(set_b_case(1).machine, start), energy / (k.kappa4 * rest), 1e-12);
}

// Half of equal windows: their means and extremes by hand.
TEST(WalkOutcome, SecondHalfIsThatOfTheWindows) {
    const WalkCase walk_case = set_b_case(100);
    const Walk walk = walking::walk(walk_case, {.tail = 2, .interval = 0.1});
    const WalkOutcome outcome = outcome_of(walk_case, walk);
    double force = 0, lowest = std::numeric_limits<double>::infinity(), deepest = -lowest;
    ASSERT_EQ(walk.windows.size() % 2, 1u);  // the one in the middle counts
    for (const auto& window : walk.windows) {
        if (window.end <= 50) continue;
        force += window.sums.spring_force;
        lowest = std::min(lowest, window.sums.z_min);
        deepest = std::max(deepest, window.sums.z_max);
    }
    double steps = 0;
    for (const auto& window : walk.windows)
        if (window.end > 50) steps += static_cast<double>(window.sums.steps);
    EXPECT_NEAR(outcome.second_half.mu_e, force / steps / (0.68 * 1e-4), 1e-12);
    EXPECT_NEAR(outcome.second_half.z_min_ratio, lowest / (1e-4 / 2.4), 1e-12);
    EXPECT_NEAR(outcome.second_half.z_max_ratio, deepest / (1e-4 / 2.4), 1e-12);
    EXPECT_EQ(outcome.samples.z.size(), walk.tail.size());
    EXPECT_NEAR(outcome.samples.interval, 0.1, 1e-9);
}

// The spring force repeats with the limit cycle, and its running variance is far above 0.1; steady
// sliding leaves the spring swinging (linearly neutral), which is no instability.
TEST(WalkOutcome, VibrationOfALimitCycleAndOfSteadySliding) {
    WalkCase walk_case = set_b_case(1500);
    const Recording recording{.tail = 200, .interval = 0.1};
    const WalkOutcome walking = outcome_of(walk_case, walk(walk_case, recording));
    ASSERT_EQ(walking.result.regime, Regime::limit_cycle);
    EXPECT_NEAR(walking.vibration.frequency * *walking.result.period, 1, 1e-3);
    EXPECT_EQ(walking.vibration.instability, 1);
    EXPECT_EQ(walking.samples.z.size(), 121u);  // 12 units of time for the page of a map
    walk_case.machine.kappas = walking::set_a();
    const WalkOutcome sliding = outcome_of(walk_case, walk(walk_case, recording));
    EXPECT_EQ(sliding.result.regime, Regime::steady);
    EXPECT_TRUE(std::isnan(sliding.vibration.frequency));
    EXPECT_EQ(sliding.vibration.instability, 0);
}

TEST(WalkOutcome, ReadsBackWhatItWrites) {
    WalkOutcome outcome;
    outcome.result.regime = Regime::limit_cycle;
    outcome.result.mu_e = 0.044;
    outcome.result.mu_e_error = std::numeric_limits<double>::infinity();  // as nothing
    outcome.result.period = 4.293;
    outcome.result.spots = {{0.4265, -0.759}, {0.4931, -0.727}};
    outcome.result.transient_over = true;
    outcome.vibration.frequency = 0.2329;
    outcome.largest_phi = 3.32e-5;
    outcome.samples = {.interval = 0.1,
                       .displacement = {1, 2},
                       .z = {3, 4},
                       .phi = {5, 6},
                       .spring_force = {7, 8.123456f}};
    const auto written = walk_results(outcome);
    for (const std::string& name : walk_result_names()) EXPECT_TRUE(written.contains(name)) << name;
    EXPECT_EQ(written.at("regime"), "limit-cycle");
    EXPECT_TRUE(written.at("mu_e_error").is_null());
    const WalkOutcome read = read_walk_results(written);
    EXPECT_EQ(read.result.regime, Regime::limit_cycle);
    EXPECT_EQ(read.result.mu_e, 0.044);
    EXPECT_TRUE(std::isnan(read.result.mu_e_error));
    EXPECT_EQ(read.result.period, 4.293);
    EXPECT_FALSE(read.result.tilting_time);
    EXPECT_EQ(read.result.spots[1].stick_time, 0.4931);
    EXPECT_EQ(read.vibration.frequency, 0.2329);
    EXPECT_EQ(read.samples.displacement, outcome.samples.displacement);
    EXPECT_NEAR(read.samples.spring_force[1], 8.1235, 1e-6);  // five digits
    EXPECT_EQ(walk_results(read), written);
}

// Columns of results.csv.
TEST(WalkOutcome, EveryNumberStandsUnderItsName) {
    WalkOutcome outcome;
    outcome.result = {.regime = Regime::shakedown,
                      .mu_e = 1,
                      .mu_e_error = 2,
                      .period = 22,
                      .section_points = 23,
                      .z_min_ratio = 3,
                      .z_max_ratio = 4,
                      .phi_min = 10,
                      .phi_max = 11,
                      .kinetic_energy = 9,
                      .spots = {{5, 7}, {100, 100}, {6, 8}},  // the first and the last
                      .transient = 12,
                      .observed = 13,
                      .tilting_time = 24,
                      .drift = WalkResult::Drift{25, 26, 27}};
    outcome.second_half = {14, 15, 16};
    outcome.vibration = {17, 18, 19};
    outcome.largest_phi = 20;
    outcome.initial_energy = 21;
    const auto written = walk_results(outcome);
    int due = 0;
    for (const char* name : {"mu_e",
                             "mu_e_error",
                             "z_min_ratio",
                             "z_max_ratio",
                             "stick_time_1",
                             "stick_time_2",
                             "correlation_1",
                             "correlation_2",
                             "kinetic_energy",
                             "phi_min",
                             "phi_max",
                             "transient",
                             "observed",
                             "mu_e_second_half",
                             "z_min_ratio_second_half",
                             "z_max_ratio_second_half",
                             "frequency",
                             "frequency_error",
                             "instability",
                             "largest_phi",
                             "initial_energy",
                             "period",
                             "section_points",
                             "tilting_time",
                             "shift_per_period",
                             "shift_per_period_error",
                             "airborne"})
        EXPECT_EQ(written.at(name), ++due) << name;
}

TEST(WalkOutcome, OfATiltingMachineHasNoMeans) {
    WalkCase walk_case = set_b_case(4000);
    walk_case.machine.kappas.kappa5 = 1.2 * critical_friction(walk_case.machine.kappas);
    const WalkOutcome outcome = outcome_of(walk_case, walk(walk_case));
    EXPECT_EQ(outcome.result.regime, Regime::tilting);
    EXPECT_TRUE(std::isnan(outcome.second_half.mu_e));
    EXPECT_TRUE(outcome.samples.z.empty());
    EXPECT_GT(outcome.largest_phi, 0.04);  // 0.1 rad of a body half as high as wide
}

}  // namespace
}  // namespace tricontact::walking::walk_outcome_test

// Regimes and statistics of the walking machine over long runs: what a different step, start,
// rounding or instruction set may not change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/verification/walking/side_by_side.h"
#include "walking/kernels/batch.h"
#include "walking/run/walk.h"

namespace tricontact::walking::dynamics_walking_test {
namespace {

// Wetter (2016), eqs. 4.1.25 and 4.1.26.
constexpr Kappas slides{2, 1.2, 0.5, 1e-4, 0.5, 1e-4, 0.42, 0.5};
constexpr Kappas walks{2, 1.2, 0.5, 1e-4, 0.68, 1e-4, 0.42, 1.18};

WalkCase case_of(const Kappas& kappas, double step, double end) {
    WalkCase walk_case;
    walk_case.machine.kappas = kappas;
    walk_case.time = {.step = step, .end = end};
    return walk_case;
}

/// A start anywhere within a static displacement and the base's velocity.
Start random_start(std::mt19937_64& generator) {
    std::uniform_real_distribution<double> share(-1, 1);
    const auto any = [&] { return share(generator); };
    return {any(), any(), any(), any(), any(), any(), any()};
}

// Set B is chaotic for 1450 on average; by 20000 one run in a million is still.
TEST(Walking, SetBIsOneLimitCycleForAllStepsAndStarts) {
    std::mt19937_64 generator(20261122);
    for (const double step : {0.9e-3, 1e-3, 1.1e-3}) {
        std::vector<WalkCase> cases(8, case_of(walks, step, 20000));
        for (std::size_t i = 1; i < cases.size(); ++i) cases[i].start = random_start(generator);
        for (const Walk& walk : walks_side_by_side(cases)) {
            const WalkResult& result = walk.result;
            ASSERT_EQ(result.regime, Regime::limit_cycle) << step;
            EXPECT_TRUE(result.transient_over);
            EXPECT_EQ(result.section_points, 1);
            // Errors of 5e-7 and 1e-6 each; drawn from the same cycle, twice that apart at most.
            EXPECT_NEAR(result.mu_e, 0.044006, 1e-6);
            EXPECT_NEAR(result.mu_e, 0.044006, 2 * result.mu_e_error + 5e-7);
            EXPECT_NEAR(*result.period, 4.292993, 2e-6);
            EXPECT_NEAR(result.z_min_ratio, -0.4289, 5e-5);
            EXPECT_NEAR(result.spots[0].stick_time, 0.4265, 2e-4);
            EXPECT_NEAR(result.spots[1].stick_time, 0.4931, 2e-4);
        }
    }
}

TEST(Walking, SetBIsTheSameLimitCycleForAllKernels) {
    for (const Kernel kernel : available_kernels()) {
        const std::vector<WalkCase> cases(2, case_of(walks, 1e-3, 10000));
        const WalkResult result = walk_batch(cases, {}, kernel)[0].result;
        EXPECT_EQ(result.regime, Regime::limit_cycle);
        EXPECT_NEAR(result.mu_e, 0.044006, 1e-6);
    }
}

TEST(Walking, SetASlidesForAllSteps) {
    for (const double step : {0.9e-3, 1e-3, 1.1e-3}) {
        const WalkResult result = walk(case_of(slides, step, 20000)).result;
        EXPECT_EQ(result.regime, Regime::steady);
        EXPECT_TRUE(result.transient_over);
        EXPECT_NEAR(result.mu_e, 1, 1e-3);
        EXPECT_NEAR(result.mu_e, 1, 2 * result.mu_e_error);
    }
}

// Means over a cycle converge with the square of the step: each halving takes three quarters of the
// error. The error that is told holds the extrapolated mean, and is not much larger.
TEST(Walking, MeansOfACycleAreOfSecondOrder) {
    std::vector<WalkResult> results;
    for (const double step : {8e-3, 4e-3, 2e-3})
        results.push_back(walk(case_of(walks, step, 10000)).result);
    const double coarse = results[0].mu_e - results[1].mu_e;
    const double fine = results[1].mu_e - results[2].mu_e;
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
    const double limit = results[2].mu_e - fine / 3;
    for (const WalkResult& result : results) {
        ASSERT_EQ(result.regime, Regime::limit_cycle);
        EXPECT_LT(std::abs(result.mu_e - limit), 1.2 * result.mu_e_error);
        EXPECT_GT(std::abs(result.mu_e - limit), 0.5 * result.mu_e_error);
    }
}

// An independent program's shares of the 2187 starts of figure 4.16 that are on the cycle by these
// times; ours are 300 of these starts. Three standard deviations of a share: 9 points at half.
TEST(Walking, TransientsOfSetBLiveAsLongAsKnown) {
    std::mt19937_64 generator(20261122);
    const auto level = [&] { return static_cast<double>(generator() % 3) - 1; };
    std::vector<WalkCase> cases(300, case_of(walks, 1e-3, 4300));
    for (WalkCase& each : cases)
        each.start = {level(), level(), level(), level(), level(), level(), level()};
    const std::vector<Walk> runs = walks_side_by_side(cases);
    const double n = static_cast<double>(runs.size());
    for (const auto& [time, share] :
         {std::pair{500., 0.18}, {1000., 0.45}, {2000., 0.75}, {4000., 0.94}}) {
        const auto n_there =
            std::count_if(runs.begin(), runs.end(), [time = time](const Walk& run) {
                return run.result.regime == Regime::limit_cycle && run.result.transient <= time;
            });
        EXPECT_NEAR(static_cast<double>(n_there) / n, share, 3 * std::sqrt(share * (1 - share) / n))
            << time;
    }
}

// Chaos for good: intervals of many runs of the same machine hold the mean of all of them. 95 % of
// 64 are 61 +- 5 (3 s); laminar phases rarer than blocks are long take some.
TEST(Walking, IntervalsOfChaosHoldTheMean) {
    std::mt19937_64 generator(20261122);
    for (const double kappa8 : {1.077, 1.385}) {
        Kappas kappas = walks;
        kappas.kappa5 = 0.685;
        kappas.kappa8 = kappa8;
        std::vector<WalkCase> cases(64, case_of(kappas, 1e-3, 20000));
        for (WalkCase& each : cases) each.start = random_start(generator);
        const std::vector<Walk> runs = walks_side_by_side(cases);
        double mean = 0;
        for (const Walk& run : runs) mean += run.result.mu_e / static_cast<double>(runs.size());
        int n_over = 0, n_held = 0;
        for (const Walk& run : runs) {
            EXPECT_EQ(run.result.regime, Regime::chaotic);
            n_over += run.result.transient_over;
            n_held += std::abs(run.result.mu_e - mean) <= run.result.mu_e_error;
        }
        EXPECT_GE(n_over, 60);
        EXPECT_GE(n_held, 55);
    }
}

}  // namespace
}  // namespace tricontact::walking::dynamics_walking_test

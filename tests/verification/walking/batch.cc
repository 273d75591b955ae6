#include "walking/kernels/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/walking/sets.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::dynamics_batch_test {
namespace {

constexpr double step = 1e-3;

class WalkingBatch : public testing::TestWithParam<Kernel> {
  protected:
    /// Sums over the window of a run of the machine from each of these starts.
    static std::vector<StretchSums> run(const Machine& machine, const std::vector<Start>& starts,
                                        double window_begin, double end) {
        std::vector<Motion> motions;
        for (const Start& start : starts) motions.push_back(motion_at_start(machine, start));
        const std::vector<Machine> machines(starts.size(), machine);
        Batch batch(machines, motions, step, GetParam());
        std::vector<StretchSums> sums(starts.size());
        batch.advance(std::llround(window_begin / step), {});
        batch.advance(std::llround((end - window_begin) / step), sums);
        return sums;
    }
};
INSTANTIATE_TEST_SUITE_P(Kernels, WalkingBatch, testing::ValuesIn(available_kernels()),
                         [](const auto& kernel) { return name_of(kernel.param); });

double mu_e(const Machine& machine, const StretchSums& sums) {
    return sums.spring_force / static_cast<double>(sums.steps) /
           (machine.kappas.kappa5 * machine.kappas.kappa4);
}

TEST_P(WalkingBatch, SetASlidesAsOneBlock) {
    const Machine machine{.kappas = set_a()};
    const StretchSums sums = run(machine, {{}}, 2000, 4000).front();
    // The spring's oscillation, undamped, does not fill its last period.
    EXPECT_NEAR(mu_e(machine, sums), 1, 1e-3);
    // When it starts a spot leaves the ground for a moment; nothing damps what z keeps of that.
    const double rest = static_displacement(machine);
    EXPECT_NEAR(sums.z_min, rest, 5e-3 * rest);
    EXPECT_NEAR(sums.z_max, rest, 5e-3 * rest);
}

// A chaotic transient, whose rounding differs from kernel to kernel, then one limit cycle: numbers
// of an independent program.
TEST_P(WalkingBatch, SetBEndsInItsLimitCycle) {
    const Machine machine{.kappas = set_b()};
    const double rest = static_displacement(machine);
    const std::vector<Start> starts{{}, {.z = 1.5}, {.x = 0.5, .phi = 0.1}};
    for (const StretchSums& sums : run(machine, starts, 16000, 20000)) {
        const double n = static_cast<double>(sums.steps);
        EXPECT_NEAR(mu_e(machine, sums), 0.0440, 1e-3);  // not over whole periods
        EXPECT_NEAR(sums.z_min / rest, -0.4289, 5e-4);
        EXPECT_NEAR(sums.z_max / rest, 2.3545, 5e-4);
        EXPECT_NEAR(static_cast<double>(sums.spots[0].sticking) / n, 0.4265, 2e-3);
        EXPECT_NEAR(static_cast<double>(sums.spots[1].sticking) / n, 0.4931, 2e-3);
        // Printed to three decimals, and not over whole periods.
        EXPECT_NEAR(correlation(sums.spots[0], sums.steps), -0.759, 1e-3);
        EXPECT_NEAR(correlation(sums.spots[1], sums.steps), -0.727, 1e-3);
        EXPECT_NEAR(sums.kinetic_energy / n / (machine.kappas.kappa4 * rest), 3.225, 5e-3);
        EXPECT_NEAR(sums.phi_min, -3.32e-5, 5e-8);
        EXPECT_NEAR(sums.phi_max, 3.12e-5, 5e-8);
    }
}

/// Way of a spot: its velocity is s', Wetter (2016), eq. 4.2.16.
double path(const Motion& motion, std::size_t spot) {
    return motion.x + motion.phi - motion.spots[spot].tangential;
}

TEST(BatchSums, VelocitiesOfTheSpotsAddUpToTheirWaysOverTenMillionSteps) {
    const Machine machine{.kappas = set_b()};
    const Motion start = motion_at_start(machine);
    Batch batch(std::span(&machine, 1), std::span(&start, 1), step);
    StretchSums sums;
    constexpr std::int64_t n = 10'000'000;
    batch.advance(n - 1, std::span(&sums, 1));
    const Motion before = batch.motion(0);
    batch.advance(1, std::span(&sums, 1));
    ASSERT_EQ(sums.steps, n);
    for (std::size_t i = 0; i < 2; ++i) {
        // Central differences: each end but the first is counted by half.
        const double way = (path(before, i) + path(batch.motion(0), i)) / 2 - path(start, i);
        // 1e7 steps that round by 1e-16 at random.
        EXPECT_NEAR(sums.spots[i].velocity * step / way, 1, 1e-12);
    }
}

/// Shares [%] of a map of kappa8 and mu.
struct Shares {
    double critical = 0, no_effect = 0, reduction = 0, below_half = 0, jumps = 0;
};

Shares shares_of_map() {
    constexpr int n = 40;
    std::vector<Machine> machines;
    std::vector<Motion> starts;
    for (int i = 0; i < n * n; ++i) {
        Kappas kappas = set_b();
        kappas.kappa5 = 0.1 + 1.9 / (n - 1) * (i % n);
        kappas.kappa8 = 2. / (n - 1) * (i / n);
        machines.push_back({.kappas = kappas});
        starts.push_back(motion_at_start(machines.back()));
    }
    Batch batch(machines, starts, step);
    std::vector<StretchSums> sums(machines.size());
    batch.advance(2'000'000, {});
    batch.advance(2'000'000, sums);
    Shares shares;
    constexpr double share = 100. / (n * n);
    for (std::size_t i = 0; i < machines.size(); ++i) {
        if (batch.tilted(i) || std::max(sums[i].phi_max, -sums[i].phi_min) > 0.01) {
            shares.critical += share;
            continue;
        }
        const double mu = mu_e(machines[i], sums[i]);
        shares.no_effect += mu > 0.99 ? share : 0;
        shares.reduction += mu < 0.95 ? share : 0;
        shares.below_half += mu < 0.5 ? share : 0;
        shares.jumps += sums[i].z_min < 0 ? share : 0;
    }
    return shares;
}

// Wetter (2016), table 4.2.1, by an independent program. Cells at the edges of the regions and in
// chaos fall this way or that.
TEST(WalkingMap, SharesAreThoseOfTheTable) {
    const Shares shares = shares_of_map();
    constexpr double points = 1;
    EXPECT_NEAR(shares.critical, 46.7, points);
    EXPECT_NEAR(shares.no_effect, 26.5, points);
    EXPECT_NEAR(shares.reduction, 25.6, points);
    EXPECT_NEAR(shares.below_half, 10.0, points);
    EXPECT_NEAR(shares.jumps, 31.2, points);
}

}  // namespace
}  // namespace tricontact::walking::dynamics_batch_test

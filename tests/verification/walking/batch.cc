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

}  // namespace
}  // namespace tricontact::walking::dynamics_batch_test

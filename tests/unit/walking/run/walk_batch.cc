#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "tests/unit/walking/sets.h"
#include "walking/run/walk.h"

namespace tricontact::walking::walk_batch_test {
namespace {

Kappas tilting() {
    Kappas kappas = set_b();
    kappas.kappa5 = 1.2 * critical_friction(kappas);
    return kappas;
}

void expect_same(const WalkResult& batch, const WalkResult& alone) {
    EXPECT_EQ(batch.regime, alone.regime);
    EXPECT_EQ(batch.transient_over, alone.transient_over);
    EXPECT_EQ(batch.section_points, alone.section_points);
    EXPECT_EQ(batch.period.has_value(), alone.period.has_value());
    EXPECT_EQ(batch.tilting_time.has_value(), alone.tilting_time.has_value());
}

// The same judge sees the same run, but for rounding: to the bit it cannot be.
TEST(WalkBatch, JudgesAsARunAlone) {
    const std::vector<WalkCase> cases{case_of(set_a(), 5000), case_of(set_b(), 5000),
                                      case_of(tilting(), 5000)};
    const std::vector<Walk> walks = walk_batch(cases);
    ASSERT_EQ(walks.size(), 3u);

    const Walk sliding = walk(cases[0]);
    expect_same(walks[0].result, sliding.result);
    EXPECT_NEAR(walks[0].result.mu_e, sliding.result.mu_e, 1e-6);
    EXPECT_EQ(walks[0].windows.size(), sliding.windows.size());
    EXPECT_EQ(walks[0].lane_steps, sliding.lane_steps);
    EXPECT_EQ(walks[0].tail.size(), sliding.tail.size());
    EXPECT_EQ(walks[0].tail.back().motion.time, sliding.tail.back().motion.time);

    const Walk walking = walk(cases[1]);
    expect_same(walks[1].result, walking.result);
    EXPECT_NEAR(walks[1].result.mu_e, walking.result.mu_e, walking.result.mu_e_error);
    EXPECT_NEAR(*walks[1].result.period, *walking.result.period, walking.result.period_error);
    EXPECT_NEAR(walks[1].result.spots[1].stick_time, walking.result.spots[1].stick_time, 1e-4);
    ASSERT_TRUE(walks[1].phases.has_value());
    EXPECT_NEAR(walks[1].phases->airborne, walking.phases->airborne, 1e-3);

    const Walk falling = walk(cases[2]);
    expect_same(walks[2].result, falling.result);
    EXPECT_NEAR(*walks[2].result.tilting_time, *falling.result.tilting_time, 0.01);
    EXPECT_NEAR(walks[2].result.phi_min, falling.result.phi_min, 1e-5);
}

TEST(WalkBatch, DoesNotDependOnOthers) {
    std::vector<WalkCase> cases;
    for (const double kappa8 : {0.4, 0.9, 1.0, 1.1, 1.18, 1.2, 1.3, 1.4, 1.5}) {
        Kappas kappas = set_b();
        kappas.kappa8 = kappa8;
        cases.push_back(case_of(kappas, 300));
    }
    const auto together = walk_batch(cases);
    const auto few = walk_batch(std::span(cases).first(2));
    for (std::size_t i = 0; i < few.size(); ++i) {
        EXPECT_EQ(together[i].result.mu_e, few[i].result.mu_e);
        EXPECT_EQ(together[i].result.mu_e_error, few[i].result.mu_e_error);
        EXPECT_EQ(together[i].tail.back().motion, few[i].tail.back().motion);
    }
}

TEST(WalkBatch, WantsOneStepAndOneEnd) {
    const std::vector<WalkCase> cases{case_of(set_a(), 10), case_of(set_a(), 20)};
    EXPECT_THROW(walk_batch(cases), std::invalid_argument);
    EXPECT_TRUE(walk_batch({}).empty());
}

}  // namespace
}  // namespace tricontact::walking::walk_batch_test

#include <gtest/gtest.h>

#include "tests/unit/walking/sets.h"
#include "walking/run/walk.h"

namespace tricontact::walking::mechanisms_test {
namespace {

WalkResult without(const Mechanisms& mechanisms) {
    WalkCase walk_case;
    walk_case.machine = {.kappas = set_b(), .mechanisms = mechanisms};
    walk_case.time = {.step = 2e-3, .end = 2000};
    return walk(walk_case).result;
}

// Undamped swings of the spring are averaged over some hundred periods: two amplitudes over the
// time leave less than this.
constexpr double mean_of_swings = 2e-3;

// Loads and bounds are constant: a block on a spring, which slides forwards all the time.
TEST(Mechanisms, WithoutRotationNothingReducesFriction) {
    const WalkResult result = without({.rotation = false});
    EXPECT_EQ(result.regime, Regime::steady);
    EXPECT_NEAR(result.mu_e, 1, mean_of_swings);
    EXPECT_EQ(result.phi_max, 0);
    EXPECT_NEAR(result.z_min_ratio, 1, 1e-12);
}

// Bodies jump, but their friction does not know.
TEST(Mechanisms, FrictionThatDoesNotFollowTheLoadIsNotReduced) {
    const WalkResult result = without({.coupling = false});
    EXPECT_NEAR(result.mu_e, 1, mean_of_swings);
    EXPECT_LT(result.z_min_ratio, 0);
}

// Guided at constant height, a body that rocks about its spots loads them with its weight,
// max(0, z + Phi) + max(0, z - Phi) >= 2 z, and with more while one of them is in the air.
TEST(Mechanisms, WithoutVerticalMotionFrictionOnlyGrows) {
    const WalkResult result = without({.vertical = false});
    EXPECT_EQ(result.z_min_ratio, 1);
    EXPECT_EQ(result.z_max_ratio, 1);
    EXPECT_GT(result.mu_e, 1.01);  // set B rocks so far that its trailing spot lifts off
    EXPECT_LT(result.mu_e, 1.1);
}

// Far from the trailing spot's lift-off it is a block again: set A, mu three eighths of mu_c.
TEST(Mechanisms, WithoutVerticalMotionSetASlides) {
    WalkCase walk_case;
    walk_case.machine = {.kappas = set_a(), .mechanisms = {.vertical = false}};
    walk_case.time = {.step = 2e-3, .end = 2000};
    EXPECT_NEAR(walk(walk_case).result.mu_e, 1, mean_of_swings);
}

}  // namespace
}  // namespace tricontact::walking::mechanisms_test

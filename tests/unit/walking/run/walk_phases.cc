#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/unit/walking/sets.h"
#include "walking/machine/machine.h"
#include "walking/run/walk.h"

namespace tricontact::walking::walk_phases_test {
namespace {

constexpr double period = 4, interval = 0.01;

// A period of 4 from its turning point: in the air from 1.5 to 2.3, three times as fast; the spots
// stick from -0.5 to 0.7 and from -0.2 to 0.3.
std::vector<Snapshot> prescribed(int n, double rest) {
    std::vector<Snapshot> snapshots;
    double x = 0;
    for (int i = 0; i < n; ++i) {
        const int phase = i % 400;
        const bool flying = phase >= 150 && phase < 230;
        const auto state = [&](int begin, int end) {
            if (flying) return SpotState::released;
            return phase >= 400 + begin || phase < end ? SpotState::stick : SpotState::slip;
        };
        Snapshot snapshot;
        snapshot.motion.time = i * interval;
        snapshot.motion.x = x;
        snapshot.motion.z = rest * (0.5 + std::cos(2 * std::numbers::pi * i * interval / period));
        snapshot.spots = {state(-50, 70), state(-20, 30)};
        snapshots.push_back(snapshot);
        x += flying ? 3 : 1;
    }
    return snapshots;
}

TEST(WalkPhases, AreThoseOfAPrescribedMotion) {
    const Machine machine{.kappas = set_b()};
    const auto snapshots = prescribed(1500, static_displacement(machine));
    const auto phases = phases_of(machine, snapshots, period);
    ASSERT_TRUE(phases.has_value());
    constexpr double turning = 8, rounding = 1e-12;  // a period before and after it
    EXPECT_NEAR(phases->turning_point, turning, rounding);
    EXPECT_NEAR(phases->sticking, turning - 0.5, rounding);
    EXPECT_NEAR(phases->release, turning + 0.7, rounding);
    EXPECT_NEAR(phases->jump, turning + 1.5, rounding);
    EXPECT_NEAR(phases->landing, turning + 2.3, rounding);
    EXPECT_NEAR(phases->jump_height, 0.5, rounding);  // at the highest point, 2
    EXPECT_NEAR(phases->airborne, 0.2, rounding);
    EXPECT_NEAR(phases->airborne_advance, 2.4 / 5.6, rounding);
}

TEST(WalkPhases, OfASlidingBodyAreNone) {
    const Machine machine{.kappas = set_b()};
    auto snapshots = prescribed(1500, static_displacement(machine));
    for (Snapshot& snapshot : snapshots) snapshot.spots = {SpotState::slip, SpotState::slip};
    const auto phases = phases_of(machine, snapshots, period);
    ASSERT_TRUE(phases.has_value());
    EXPECT_TRUE(std::isnan(phases->sticking));
    EXPECT_TRUE(std::isnan(phases->release));
    EXPECT_TRUE(std::isnan(phases->jump));
    EXPECT_TRUE(std::isnan(phases->landing));
    EXPECT_EQ(phases->jump_height, 0);
    EXPECT_EQ(phases->airborne, 0);
}

TEST(WalkPhases, NeedThreePeriods) {
    const Machine machine{.kappas = set_b()};
    EXPECT_FALSE(phases_of(machine, prescribed(1200, 1), period).has_value());
    EXPECT_TRUE(phases_of(machine, prescribed(1201, 1), period).has_value());
}

}  // namespace
}  // namespace tricontact::walking::walk_phases_test

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/unit/walking/sets.h"
#include "walking/run/walk_judge.h"

namespace tricontact::walking::drive_load_test {
namespace {

const Machine machine{.kappas = set_b()};

// Windows of 20 by 1000 steps: force over that of sliding, velocity of both spots over the base's.
template <class Force, class Velocity>
std::vector<WalkWindow> windows(int n, double sticking, Force force, Velocity velocity) {
    std::vector<WalkWindow> all;
    for (int i = 0; i < n; ++i) {
        WalkWindow window{20. * i, 20. * (i + 1), {}};
        window.sums.steps = 1000;
        window.sums.spring_force = 1000 * force(i) * sliding_force(machine);
        window.sums.spots.resize(2);
        for (SpotSums& spot : window.sums.spots) {
            spot.velocity = 1000 * velocity(i) * machine.kappas.kappa6;
            spot.sticking = std::llround(1000 * sticking);
        }
        all.push_back(window);
    }
    return all;
}

double even(int) {
    return 1;
}

// A window ahead of the base, a window behind, by so many of its velocities: the ways at the ends
// are off by 20 times that of 2000. From 25 on, twice that and more than all of the way, nothing
// tells it from swinging on the spot.
TEST(DriveLoad, TellsSlidingFromSwinging) {
    const auto moves = [](double swing, double lag) {
        return moves_with_base(machine, windows(100, 0, even, [=](int i) {
                                   return 1 - lag + (i % 2 ? -swing : swing);
                               }));
    };
    EXPECT_TRUE(moves(0, 0));
    EXPECT_TRUE(moves(20, 0));
    EXPECT_FALSE(moves(60, 0));
    EXPECT_FALSE(moves(0, 1e-3));  // without a swing nothing explains a lag
    EXPECT_TRUE(moves(1, 1e-3));
    EXPECT_FALSE(moves(1, 0.1));
    EXPECT_FALSE(moves(1, 1));
    // A base that rests has nothing to be compared with.
    Machine still = machine;
    still.kappas.kappa6 = 0;
    EXPECT_TRUE(moves_with_base(still, windows(4, 0, even, even)));
}

// The spring is loaded in the first window, and the spots lag behind by that way for good.
TEST(DriveLoad, AWayThatTheSpringTookUpOnceIsNoLag) {
    EXPECT_TRUE(
        moves_with_base(machine, windows(100, 0, even, [](int i) { return i > 0 ? 1. : 0.; })));
}

// A force that rises by half of what is left in each third of the time, the spots sticking now and
// then: of what is to come the error holds the most, and never more than the way to sliding.
TEST(DriveLoad, TheErrorHoldsWhatIsToCome) {
    for (const double end : {1., 0.8}) {
        const auto rising = windows(
            90, 0.01, [=](int i) { return end - 0.1 * std::exp2(-i / 30.); }, even);
        double mean = 0;
        for (const WalkWindow& window : rising) mean += mean_force(window) / 90;
        const double error = mean_error(machine, rising);
        EXPECT_GE(error, end * sliding_force(machine) - mean);
        EXPECT_LE(error, sliding_force(machine) - mean + 1e-12);
    }
}

// Spots that stick for instants while nothing is missing of the force of sliding: a swing that
// comes to rest and that nothing damps. Its error is the range of the integral, a window of 0.01.
TEST(DriveLoad, StickingThatTakesNothingIsSliding) {
    for (const double sticking : {0., 0.001, 0.1}) {
        const auto swinging = windows(
            100, sticking, [](int i) { return i % 2 ? 0.99 : 1.01; }, even);
        EXPECT_NEAR(mean_error(machine, swinging) / sliding_force(machine), 0.01 / 100, 1e-12);
    }
}

}  // namespace
}  // namespace tricontact::walking::drive_load_test

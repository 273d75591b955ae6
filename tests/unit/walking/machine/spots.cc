#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/walking/sets.h"
#include "walking/machine/motion.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::spots_test {
namespace {

Machine with_spots(const Kappas& kappas, std::vector<Spot> spots) {
    return {.kappas = kappas, .model = Machine::Model::spots, .spots = std::move(spots)};
}

std::vector<Spot> equal_spots(int n) {
    std::vector<Spot> spots;
    for (int i = 0; i < n; ++i) spots.push_back({.position = -1 + 2. * i / (n - 1)});
    return spots;
}

Motion after(const Machine& machine, double time) {
    VelocityVerlet run(machine, motion_at_start(machine), 1e-3);
    while (run.motion().time < time && std::abs(run.motion().phi) < 1) run.advance();
    return run.motion();
}

TEST(Spots, AtBothEndsAreTheTwoSpotMachine) {
    EXPECT_EQ(after(with_spots(set_b(), {{-1}, {1}}), 20), after({.kappas = set_b()}, 20));
}

TEST(Spots, ShareTheWeight) {
    const Kappas k = set_a();
    for (const int n : {2, 3, 7}) {
        const Machine machine = with_spots(k, equal_spots(n));
        EXPECT_NEAR(static_displacement(machine) * n * k.kappa2 / k.kappa4, 1, 1e-14) << n;
    }
    // Stiffer spots carry more: springs side by side.
    const Machine uneven = with_spots(k, {{-1, 0, 2.5}, {0.2, 0, 0.5}, {1, 0, 1}});
    EXPECT_NEAR(static_displacement(uneven) * 4 * k.kappa2 / k.kappa4, 1, 1e-14);
}

TEST(Spots, OfDifferentHeightsCarryOneAfterAnother) {
    const Kappas k = set_a();
    const double one = k.kappa4 / k.kappa2;  // weight over k_z b
    // The tip above the others by the depth under the whole weight stays clear, at half of it
    // carries: 2 z + (z - one/4) = one.
    EXPECT_NEAR(static_displacement(with_spots(k, {{-1}, {0, one}, {1}})) / one, 0.5, 1e-14);
    EXPECT_NEAR(static_displacement(with_spots(k, {{-1}, {0, one / 4}, {1}})) / one, 1.25 / 3,
                1e-14);
    // A tip that stands out carries first: (z + one/4) + 2 z = one; alone if it stands out enough.
    EXPECT_NEAR(static_displacement(with_spots(k, {{-1}, {0, -one / 4}, {1}})) / one, 0.25, 1e-14);
    EXPECT_NEAR(static_displacement(with_spots(k, {{-1}, {0, -2 * one}, {1}})) / one, -1, 1e-14);
    // At rest it stays at rest.
    const Machine machine =
        with_spots({k.kappa1, k.kappa2, k.kappa3, k.kappa4, k.kappa5, 0, k.kappa7, k.kappa8},
                   {{-1, one / 5}, {0, 0}, {1, one / 5}});
    const Motion start = motion_at_start(machine);
    const Acceleration at_rest = acceleration(machine, spots_of(machine), start);
    EXPECT_NEAR(at_rest.z / k.kappa4, 0, 1e-14);
    EXPECT_NEAR(at_rest.phi / k.kappa4, 0, 1e-14);
}

// Steady sliding, balance of moments about the middle of the base: the spots tilt by
// Phi = -mu kappa4 kappa3 (1 + kappa8)/(kappa2 sum p^2).
TEST(Spots, SlideSteadilyUnderTheirTilt) {
    const Kappas k = set_a();
    for (const int n : {2, 5}) {
        const Machine machine = with_spots(k, equal_spots(n));
        const std::vector<Spot> spots = spots_of(machine);
        double squares = 0;
        for (const Spot& spot : spots) squares += spot.position * spot.position;
        const double rotation =
            -k.kappa5 * k.kappa4 * k.kappa3 * (1 + k.kappa8) / (k.kappa2 * squares);
        Motion motion{.z = static_displacement(machine), .phi = k.kappa3 * rotation};
        motion.base = k.kappa5 * k.kappa4 / k.kappa1 - k.kappa8 * motion.phi;
        for (const Spot& spot : spots) {
            const double n_i = approach(spot, motion.z, rotation);
            motion.spots.push_back({.normal = n_i, .tangential = k.kappa5 * k.kappa2 * n_i});
        }
        const Acceleration left = acceleration(machine, spots, motion);
        EXPECT_NEAR(left.x / k.kappa4, 0, 1e-12);
        EXPECT_NEAR(left.z / k.kappa4, 0, 1e-12);
        EXPECT_NEAR(left.phi / k.kappa4, 0, 1e-3);  // levers move by phi, some 1e-4 of b
    }
}

TEST(Spots, TiltAboveTheCriticalFrictionHoweverMany) {
    for (const int n : {2, 5}) {
        for (const double ratio : {0.9, 1.2}) {
            Kappas k = set_a();
            k.kappa5 = ratio * critical_friction(k);
            const double phi = after(with_spots(k, equal_spots(n)), 400).phi;
            EXPECT_EQ(std::abs(phi) > 0.01, ratio > 1) << n << ' ' << ratio << ' ' << phi;
        }
    }
}

}  // namespace
}  // namespace tricontact::walking::spots_test

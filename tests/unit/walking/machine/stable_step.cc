#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/walking/sets.h"
#include "walking/machine/linear_stability.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::stable_step_test {
namespace {

constexpr double rounding = 1e-14;

// Without rotation x and z vibrate alone: on kappa1 + 2 and on 2 kappa2.
TEST(StableStep, IsTheOneOfTwoSpringsWithoutRotation) {
    Machine machine{.kappas = set_b(), .mechanisms = {.rotation = false}};
    EXPECT_NEAR(highest_frequency(machine), std::sqrt(2 + 2), rounding);
    machine.kappas.kappa2 = 5;
    EXPECT_NEAR(highest_frequency(machine), std::sqrt(2 * 5.), rounding);
    machine.mechanisms.vertical = false;
    EXPECT_NEAR(stable_step(machine), 2 / std::sqrt(2 + 2), rounding);
}

// Two degrees of freedom, x and phi: the greater root of the quadratic that the determinant is.
TEST(StableStep, IsTheGreaterRootOfTheCoupledPair) {
    const Machine machine{.kappas = set_b()};
    const auto& [k1, k2, k3, k4, mu, k6, k7, k8] = machine.kappas;
    const double mass = k7 / (k3 * k3);
    const double xx = k1 + 2, xp = 2 - k1 * k8, pp = (k1 * k8 * k8 + 2 + 2 * k2 / (k3 * k3)) / mass;
    const double square = (xx + pp) / 2 + std::sqrt((xx - pp) * (xx - pp) / 4 + xp * xp / mass);
    EXPECT_NEAR(highest_frequency(machine), std::sqrt(square), 10 * rounding);
}

// In the prism each side is as stiff as two contacts on flanks of 45 degrees.
TEST(StableStep, CountsBothFlanksOfThePrism) {
    const Machine machine{
        .kappas = set_b(), .model = Machine::Model::prism, .mechanisms = {.rotation = false}};
    EXPECT_NEAR(highest_frequency(machine), std::sqrt(2 + 4), rounding);
}

// Largest |phi| over kappa4 of a run that sticks throughout, after a gentle start.
double largest_rotation(Machine machine, double step_ratio) {
    machine.kappas.kappa5 = 1e6;
    machine.kappas.kappa6 = 1e-9 * machine.kappas.kappa4;
    const double step = step_ratio * stable_step(machine);
    VelocityVerlet run(machine, motion_at_start(machine), step);
    double largest = 0;
    for (int i = 0; i < 400; ++i) {
        run.advance();
        largest = std::max(largest, std::abs(run.motion().phi));
    }
    return largest / machine.kappas.kappa4;
}

// 0.1 % from the limit: it is a limit, not an estimate. Above it the motion grows by
// exp(2 sqrt(2 0.001)), 9 %, each step.
TEST(StableStep, PartsRunsThatStayFromRunsThatBlowUp) {
    Machine machine{.kappas = set_b()};
    for (const auto model :
         {Machine::Model::two_spot, Machine::Model::prism, Machine::Model::spots}) {
        machine.model = model;
        machine.spots = {{-1, 0, 1}, {0.2, 0, 1.5}, {1, 0, 0.7}};  // balanced: level at rest
        const double below = largest_rotation(machine, 0.999);
        const double above = largest_rotation(machine, 1.001);
        EXPECT_LT(below, 1e-6);
        EXPECT_GT(above, 1e3 * below);
    }
}

}  // namespace
}  // namespace tricontact::walking::stable_step_test

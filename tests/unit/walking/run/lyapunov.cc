#include "walking/run/lyapunov.h"

#include <gtest/gtest.h>

#include <complex>
#include <numbers>

#include "tests/unit/walking/sets.h"
#include "walking/machine/linear_stability.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::lyapunov_test {
namespace {

/// Exponent of small disturbances of steady sliding over half turns of its leading mode: the
/// distance then grows by the rate alone, whatever the form of the orbit.
statistics::Mean exponent_of(const Machine& machine, const Motion& steady,
                             std::complex<double> leading, int half_turns_before, int half_turns) {
    const double half_turn = std::numbers::pi / leading.imag();
    return lyapunov_exponent(machine, steady,
                             {.step = half_turn / 1000,
                              .interval = half_turn,
                              .alignment = half_turns_before * half_turn,
                              .duration = half_turns * half_turn});
}

// Steady sliding that flutters: disturbances grow as its leading eigenvalue says.
TEST(Lyapunov, IsTheGrowthRateOfAFlutteringMachine) {
    Machine machine{
        .kappas = set_b(), .model = Machine::Model::spots, .spots = {{-0.7, 0, 1}, {1.3, 0, 0.9}}};
    machine.kappas.kappa5 = 0.6, machine.kappas.kappa8 = 0.8;
    const auto steady = steady_sliding(machine);
    ASSERT_TRUE(steady);
    const std::complex<double> leading = leading_eigenvalue(machine, *steady);
    const statistics::Mean found = exponent_of(machine, *steady, leading, 30, 10);
    EXPECT_NEAR(found.value / leading.real(), 1, 0.01);
}

// In the prism sliding attracts: the slowest mode, alone after some time.
TEST(Lyapunov, IsTheDecayRateOfStableSliding) {
    Machine machine{.kappas = set_b(), .model = Machine::Model::prism};
    machine.kappas.kappa5 = 0.2;
    const auto steady = steady_sliding(machine);
    ASSERT_TRUE(steady);
    const std::complex<double> leading = leading_eigenvalue(machine, *steady);
    const statistics::Mean found = exponent_of(machine, *steady, leading, 60, 10);
    EXPECT_NEAR(found.value / leading.real(), 1, 0.01);
}

// The rig of Wetter (2016), set 5, on both sides of the height of its spring where the leading
// eigenvalue changes its sign, whatever the velocity: disturbances decay with the spring low, grow
// with it higher up.
TEST(Lyapunov, ChangesItsSignWhereTheRigBeginsToFlutter) {
    for (const double kappa8 : {-0.85, -0.80}) {
        const Machine rig{.kappas = {2, 1.33, 1.51, 2e-4, 0.75, 3e-4, 1.77, kappa8},
                          .model = Machine::Model::prism};
        const auto steady = steady_sliding(rig);
        ASSERT_TRUE(steady);
        const std::complex<double> leading = leading_eigenvalue(rig, *steady);
        EXPECT_EQ(leading.real() > 0, kappa8 > -0.825);
        Machine faster = rig;
        faster.kappas.kappa6 *= 10;
        const auto faster_sliding = steady_sliding(faster);
        ASSERT_TRUE(faster_sliding);
        EXPECT_EQ(leading_eigenvalue(faster, *faster_sliding).real() > 0, kappa8 > -0.825);
        const statistics::Mean found = exponent_of(rig, *steady, leading, 300, 20);
        EXPECT_NEAR(found.value / leading.real(), 1, 0.02);
    }
}

// Set A: the spring swings on undamped. What is a bounded oscillation of the distance contributes
// the logarithm of its range over the time, below 3/500.
TEST(Lyapunov, IsZeroWhereVibrationsPersist) {
    const Machine machine{.kappas = set_a()};
    const statistics::Mean found =
        lyapunov_exponent(machine, motion_at_start(machine), {.alignment = 100, .duration = 500});
    EXPECT_NEAR(found.value, 0, 0.006);
    EXPECT_LT(found.error, 0.02);
}

// Gronwall: while spots slip, a distance changes no faster than its rate, the norm of the equations
// of motion, some ten, and what a spot moves beside a neighbour that sticks, kappa6 over the
// distance, 240. A neighbour put off its friction bound is first brought back to it; that counted
// as growth would be a tenth in a single step, a rate of 10^4.
TEST(Lyapunov, RatesOfAnIntervalAsShortAsAStepAreThoseOfTheMotion) {
    const Machine machine{.kappas = set_b()};
    const auto steady = steady_sliding(machine);
    ASSERT_TRUE(steady);
    const auto rates = separation_rates(
        machine, *steady,
        {.step = 1e-5, .interval = 1e-5, .alignment = 0, .duration = 5e-5, .distance = 0.01});
    ASSERT_EQ(rates.size(), 5u);
    for (const double rate : rates) EXPECT_LT(std::abs(rate), 1000);
}

}  // namespace
}  // namespace tricontact::walking::lyapunov_test

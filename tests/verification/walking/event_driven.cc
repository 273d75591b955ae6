#include "walking/machine/event_driven.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/unit/walking/sets.h"
#include "walking/machine/energy.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::dynamics_event_driven_test {
namespace {

double distance(const Motion& a, const Motion& b) {
    return std::hypot(a.x - b.x, a.z - b.z, a.phi - b.phi);
}

Motion by_verlet(const Machine& machine, const Start& start, double end, int n_steps) {
    VelocityVerlet run(machine, motion_at_start(machine, start), end / n_steps);
    for (int i = 0; i < n_steps; ++i) run.advance();
    return run.motion();
}

// Errors of velocity Verlet over the static displacement with 500, 1000, 2000 and 4000 steps per
// unit of time. Where in a step an event falls changes the error: root mean square of 100 steps, up
// to 10 % shorter.
std::array<double, 4> verlet_errors(const Machine& machine, const Start& start, double end) {
    EventDriven reference(machine, motion_at_start(machine, start), 1e-13);
    reference.advance_to(end);
    const Motion exact = reference.motion();
    constexpr int n_samples = 100;
    std::array<double, 4> errors{};
    double n_steps = 500 * end;
    for (double& error : errors) {
        for (int i = 0; i < n_samples; ++i) {
            const int n = static_cast<int>(n_steps * (1 + 0.1 * i / n_samples));
            error += std::pow(distance(by_verlet(machine, start, end, n), exact), 2) / n_samples;
        }
        error = std::sqrt(error) / static_displacement(machine);
        n_steps *= 2;
    }
    return errors;
}

void expect_order(const std::array<double, 4>& errors, double order, double tolerance) {
    for (std::size_t i = 1; i < errors.size(); ++i)
        EXPECT_NEAR(std::log2(errors[i - 1] / errors[i]), order, tolerance)
            << errors[i - 1] << " " << errors[i];
}

// No event: Verlet's own order, the next term of its error is smaller by the step squared.
TEST(VelocityVerletOrder, IsTwoWithoutEvents) {
    Machine machine{.kappas = set_b()};
    machine.kappas.kappa5 = 50;
    expect_order(verlet_errors(machine, {}, 0.9), 2, 0.01);
}

// Events of set B: the force is continuous there, its kink costs a step's square; so does the
// deflection with which a spot sticks, as slip ends with velocity zero. They leave the order,
// where in a step they fall scatters the error.
TEST(VelocityVerletOrder, IsTwoWhereSpotsLandSlipping) {
    expect_order(verlet_errors({.kappas = set_b()}, {}, 10), 2, 0.05);
}

// A spot that sticks from its landing on keeps a deflection that counts the whole of the step in
// which it landed, the part in the air as well: off by a step times the velocity.
TEST(VelocityVerletOrder, IsOneWhereSpotsLandSticking) {
    Machine machine{.kappas = set_b(), .mechanisms = {.rotation = false}};
    machine.kappas.kappa5 = 3;
    expect_order(verlet_errors(machine, {.x = 0.3, .z = -1.3}, 3), 1, 0.1);
}

// On a flank the slip turns. The radial return takes the direction at the end of the step: backward
// Euler.
TEST(VelocityVerletOrder, IsOneInThePrism) {
    expect_order(verlet_errors({.kappas = set_b(), .model = Machine::Model::prism}, {}, 10), 1,
                 0.01);
}

// The spec: a step of 1e-4 is right to 1e-6 of the static displacement after ten units of time.
TEST(EventDrivenReference, AgreesWithShortStepsOfVerlet) {
    const Machine machine{.kappas = set_b()};
    EventDriven reference(machine, motion_at_start(machine), 1e-13);
    reference.advance_to(10);
    const Motion motion = by_verlet(machine, {}, 10, 100000);
    EXPECT_LT(distance(motion, reference.motion()) / static_displacement(machine), 1e-6);
}

// The numbers of the specification, found by velocity Verlet in an independent program; the
// tolerances are its own. Its chaotic transient lasts 1450 on average.
TEST(EventDrivenReference, EndsInTheLimitCycleOfSetB) {
    const Machine machine{.kappas = set_b()};
    EventDriven run(machine, motion_at_start(machine), 1e-12);
    run.advance_to(16000);
    const ReferenceCycle first = reference_cycle(run), second = reference_cycle(run);
    EXPECT_NEAR(first.period, 4.2930, 0.5e-4);
    EXPECT_NEAR(first.period, second.period, 1e-8);
    EXPECT_NEAR(first.stick_times[0], 0.4265, 0.002);
    EXPECT_NEAR(first.stick_times[1], 0.4931, 0.002);
    EXPECT_NEAR(first.z_min / static_displacement(machine), -0.4289, 0.0005);
    EXPECT_NEAR(first.spring_force / sliding_force(machine), 0.0440, 0.0005);
    const EnergyBalance& balance = first.balance;
    // A cycle stores nothing: what the base does is dissipated, but for the moments that have no
    // potential, a share of the order of phi. Steps are accurate to 1e-12 of the static
    // displacement, z swings by 2.8 of it.
    EXPECT_NEAR(balance.residual() / balance.base, 0, 1e-10);
    EXPECT_NEAR(balance.stored / balance.base, 0, 1e-7);
    EXPECT_NEAR(balance.geometric / balance.base, 3.2e-4, 0.1e-4);
    // Velocity Verlet with the usual step over the same period, and with one of a tenth. The
    // requirement: 1e-6 of the base's work.
    Motion start = first.start;
    start.x -= start.base;  // where x is large, its rounding is
    start.base = 0;
    for (const int n_steps : {4293, 42930}) {
        VelocityVerlet verlet(machine, start, first.period / n_steps);
        const EnergyBalance works = verlet_balance(verlet, n_steps);
        EXPECT_NEAR(works.residual() / balance.base, 0, 1e-6) << n_steps;
        EXPECT_NEAR(works.dissipation / balance.dissipation, 1, 2e-5) << n_steps;
    }
}

}  // namespace
}  // namespace tricontact::walking::dynamics_event_driven_test

#include "walking/machine/energy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/walking/sets.h"
#include "walking/machine/event_driven.h"
#include "walking/machine/motion.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::energy_test {
namespace {

EnergyBalance by_verlet(const Machine& machine, double step, double end) {
    VelocityVerlet run(machine, motion_at_start(machine), step);
    return verlet_balance(run, std::lround(end / step));
}

EnergyBalance by_reference(const Machine& machine, double end) {
    EventDriven run(machine, motion_at_start(machine), 1e-13);
    run.advance_to(end);
    return run.energy_balance();
}

// A machine in any sticking state, all scales different from 1.
Motion any_motion(const Machine& machine) {
    Motion motion = motion_at_start(machine, {.x = 0.3,
                                              .z = 1.2,
                                              .phi = 0.15,
                                              .base = 0.9,
                                              .x_velocity = 0.7,
                                              .z_velocity = -0.4,
                                              .phi_velocity = 1.6});
    for (SpotDeflection& spot : motion.spots) spot.tangential = 0.3 * spot.normal;
    return motion;
}

// While everything sticks, the stored energy changes by the powers of the base and of the moment
// without a potential. Newton's law of forces.h and the energies of energy.h: neither knows the
// other. Lengths 2000 times those of set B make that moment one of the large ones.
TEST(Energy, ChangesByThePowersOfBaseAndGeometricMoment) {
    Machine machine{.kappas = set_b()};
    machine.kappas.kappa4 = machine.kappas.kappa6 = 0.2;
    const std::vector<Spot> spots = spots_of(machine);
    const Motion motion = any_motion(machine);
    const Acceleration a = acceleration(machine, spots, motion);
    const auto stored_after = [&](double h) {
        Motion there = motion;
        there.base += machine.kappas.kappa6 * h;
        there.x += motion.x_velocity * h;
        there.z += motion.z_velocity * h;
        there.phi += motion.phi_velocity * h;
        there.x_velocity += a.x * h;
        there.z_velocity += a.z * h;
        there.phi_velocity += a.phi * h;
        for (std::size_t i = 0; i < spots.size(); ++i) {
            there.spots[i].normal = approach(spots[i], there.z, there.phi / machine.kappas.kappa3);
            there.spots[i].tangential += (motion.x_velocity + motion.phi_velocity) * h;
        }
        return stored_energy(machine, spots, there);
    };
    // The energies are quadratic: central differences are exact but for rounding.
    constexpr double h = 1e-2;
    const double change = (stored_after(h) - stored_after(-h)) / (2 * h);
    const EnergyBalance power = work(machine, working_forces(machine, spots, motion),
                                     machine.kappas.kappa6, motion.z_velocity, motion.phi_velocity);
    EXPECT_NEAR((power.base + power.geometric) / change, 1, 1e-11);
    EXPECT_GT(std::abs(power.geometric / change), 0.01);
}

// The moment without a potential is of second order: its share falls as all lengths do.
TEST(Energy, NeedsTheGeometricMomentInProportionToTheRotation) {
    Machine machine{.kappas = set_b()};
    const EnergyBalance large = by_reference(machine, 40);
    machine.kappas.kappa4 /= 100, machine.kappas.kappa6 /= 100;
    const EnergyBalance small = by_reference(machine, 40);
    EXPECT_NEAR(small.geometric / small.base / (large.geometric / large.base), 0.01, 1e-4);
    EXPECT_NEAR(large.residual() / large.base, 0, 1e-12);
    EXPECT_NEAR(small.residual() / small.base, 0, 1e-12);
}

// Stick-slip of a block that neither lands nor lifts off: to rounding with steps of any length.
TEST(VerletBalance, BalancesExactlyThroughStickAndSlip) {
    const Machine machine{.kappas = set_b(), .mechanisms = {.rotation = false}};
    for (const double step : {0.7, 0.01}) {
        const EnergyBalance balance = by_verlet(machine, step, 70);
        EXPECT_GT(balance.dissipation / balance.base, 0.5);
        EXPECT_NEAR(balance.residual() / balance.base, 0, 1e-13);
    }
}

// Landing and lift-off in the models, and with a harmonic load: the reference balances, Verlet to
// the 1e-6 required of it, and the two agree in every work: nearby motions of set B come apart by
// a factor of 1000 in this time, a step of 1e-4 is right to 1e-8 in each unit of it.
TEST(VerletBalance, AgreesWithTheReferenceInEveryWork) {
    Machine two_spot{.kappas = set_b()};
    Machine excited = two_spot, prism = two_spot, spots = two_spot, rounded = two_spot;
    rounded.bed = Bed{.radius = 0.5, .springs = 8};
    excited.excitation = {.moment = 1e-5, .force = 3e-5, .frequency = 1.3};
    prism.model = Machine::Model::prism;
    spots.model = Machine::Model::spots;
    spots.spots = {{-1, 0, 1}, {0.2, 1e-5, 1.5}, {0.5, 0, 0.3}, {1, 0, 0.9}};
    for (const Machine& machine : {two_spot, excited, prism, spots, rounded}) {
        constexpr double error = 1e-4;
        const EnergyBalance exact = by_reference(machine, 40), close = by_verlet(machine, 1e-4, 40);
        const double unit = exact.base;
        EXPECT_NEAR(exact.residual() / unit, 0, 1e-12);
        EXPECT_NEAR(close.residual() / unit, 0, 1e-6);
        EXPECT_NEAR(close.base / unit, 1, error);
        EXPECT_NEAR(close.excitation / unit, exact.excitation / unit, error);
        EXPECT_NEAR(close.dissipation / unit, exact.dissipation / unit, error);
        EXPECT_NEAR(close.geometric / unit, exact.geometric / unit, error);
        EXPECT_GT(exact.dissipation / unit, 0.2);
    }
}

}  // namespace
}  // namespace tricontact::walking::energy_test

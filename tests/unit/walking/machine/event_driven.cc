#include "walking/machine/event_driven.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "tests/unit/walking/sets.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::event_driven_test {
namespace {

constexpr double tolerance = 1e-12;
// Errors of some hundred steps add up.
constexpr double accuracy = 1e-10;

// Lifted: a parabola down to the ground, while the spring swings the body back and forth.
TEST(EventDriven, FliesAndLandsAsClosedFormsDo) {
    const Machine machine{.kappas = set_b(), .mechanisms = {.rotation = false}};
    const auto& [k1, k2, k3, k4, mu, k6, k7, k8] = machine.kappas;
    const double rest = static_displacement(machine), height = 7 * rest, lift = 1.5 * k6;
    EventDriven run(machine, motion_at_start(machine, {.x = 0.3, .z = -7, .z_velocity = -1.5}),
                    tolerance);
    const double landing = (lift + std::sqrt(lift * lift + 2 * k4 * height)) / k4;
    ASSERT_TRUE(run.advance_to_event(2 * landing));
    const Motion motion = run.motion();
    EXPECT_NEAR(motion.time, landing, accuracy);
    // Stretch of the spring: y'' = -kappa1 y, y = -0.3 rest and y' = kappa6 at the start.
    const double omega = std::sqrt(k1), t = landing;
    const double stretch = -0.3 * rest * std::cos(omega * t) + k6 / omega * std::sin(omega * t);
    EXPECT_NEAR((motion.base - motion.x) / rest, stretch / rest, accuracy);
    EXPECT_NEAR(motion.z_velocity / k6, (k4 * t - lift) / k6, accuracy);
}

// z = z_stat (1 - a cos(omega t)) with a just above 1: the spots leave the ground for a share of
// sqrt(2 (a - 1))/pi of the period, far shorter than a step.
TEST(EventDriven, SeesALiftOffWithinAStep) {
    Machine machine{.kappas = set_b(), .mechanisms = {.rotation = false}};
    machine.kappas.kappa6 = 0;
    const double period = 2 * std::numbers::pi / std::sqrt(2 * machine.kappas.kappa2);
    for (const double above : {-1e-6, 1e-6, 1e-5}) {
        EventDriven run(machine, motion_at_start(machine, {.z = 2 + above}), tolerance);
        int n_events = 0;
        while (run.advance_to_event(0.99 * period)) ++n_events;  // highest in the middle of it
        EXPECT_EQ(n_events, above > 0 ? 4 : 0) << above;         // two spots lift off and land
    }
}

// One block on two spots: sticks until its springs reach their bound, then slides about the
// constant stretch mu kappa4/kappa1.
TEST(EventDriven, SticksAndSlipsAsABlockDoes) {
    const Machine machine{.kappas = set_b(), .mechanisms = {.vertical = false, .rotation = false}};
    const auto& [k1, k2, k3, k4, mu, k6, k7, k8] = machine.kappas;
    const double rest = static_displacement(machine), omega = std::sqrt(k1 + 2);
    const auto stuck = [&](double t) {
        return k1 * k6 / (omega * omega) * (t - std::sin(omega * t) / omega);
    };
    EventDriven run(machine, motion_at_start(machine), tolerance);
    run.advance_to(0.4);
    EXPECT_NEAR(run.motion().x / rest, stuck(0.4) / rest, accuracy);
    ASSERT_TRUE(run.advance_to_event(10));  // the spots reach their bounds at one time
    const Motion onset = run.motion();
    EXPECT_NEAR(stuck(onset.time) / rest, mu * k2, accuracy);
    // y = x_s - x about its mean: y'' + kappa1 y = mu kappa4.
    run.advance_to(onset.time + 0.5);
    const double swing = std::sqrt(k1), mean = mu * k4 / k1;
    const double before = onset.base - onset.x - mean, speed = k6 - onset.x_velocity;
    const double stretch =
        mean + before * std::cos(swing * 0.5) + speed / swing * std::sin(swing * 0.5);
    const Motion motion = run.motion();
    EXPECT_NEAR((motion.base - motion.x) / rest, stretch / rest, accuracy);
    EXPECT_NEAR(motion.spots[0].tangential / rest, mu * k2, accuracy);
}

// All spots stick: q'' = -K q + g, by the modes of K. Loads are so small that moments of second
// order in phi, kappa4 times smaller, vanish in rounding.
TEST(EventDriven, VibratesInTheModesOfTheStickingMachine) {
    Machine machine{.kappas = set_b(),
                    .model = Machine::Model::spots,
                    .spots = {{-1, 0, 1}, {0.2, 0, 1.5}, {1, 0, 0.7}}};
    machine.kappas.kappa4 = 1e-14, machine.kappas.kappa5 = 1e3, machine.kappas.kappa6 = 0;
    const auto& [k1, k2, k3, k4, mu, k6, k7, k8] = machine.kappas;
    const double rest = static_displacement(machine);
    EventDriven run(machine, motion_at_start(machine, {.x = 0.2, .z = 1.3, .phi = 0.1}), tolerance);
    // Newton's law in x, z, phi about the rest, as Wetter (2016), eqs. 4.1.17 to 4.1.19, has it.
    Eigen::Matrix3d stiffness;
    double n = 0, nm = 0, nmm = 0;
    for (const Spot& spot : machine.spots) {
        n += spot.stiffness;
        nm += spot.stiffness * spot.position;
        nmm += spot.stiffness * spot.position * spot.position;
    }
    const double inertia = k7 / (k3 * k3);
    stiffness << n + k1, 0, n - k1 * k8,                   //
        0, k2 * n, -k2 * nm / k3,                          //
        (n - k1 * k8) / inertia, -k2 * nm / k3 / inertia,  //
        (n + k1 * k8 * k8 + k2 * nmm / (k3 * k3)) / inertia;
    // The springs are relaxed where the run starts, at x = 0.2, phi = 0.1: their loads there.
    const Eigen::Vector3d start(0.2, 0.3, 0.1);
    const double shear = 0.2 + 0.1;
    const Eigen::Vector3d load(n * shear, 0, n * shear / inertia);
    const Eigen::Vector3d middle = stiffness.partialPivLu().solve(load);
    const Eigen::EigenSolver<Eigen::Matrix3d> modes(stiffness);
    const Eigen::Matrix3d vectors = modes.eigenvectors().real();
    Eigen::Vector3d amplitudes = vectors.partialPivLu().solve(start - middle);
    const double time = 12.5;
    for (int i = 0; i < 3; ++i)
        amplitudes[i] *= std::cos(std::sqrt(modes.eigenvalues()[i].real()) * time);
    const Eigen::Vector3d there = middle + vectors * amplitudes;
    EXPECT_FALSE(run.advance_to_event(time));
    const Motion motion = run.motion();
    EXPECT_NEAR(motion.x / rest, there[0], accuracy);
    EXPECT_NEAR(motion.z / rest - 1, there[1], accuracy);
    EXPECT_NEAR(motion.phi / rest, there[2], accuracy);
}

// Landing, lift-off, stick and slip of set B: what a smaller tolerance changes is of the order of
// the larger one, a few hundred steps of it. The trajectory of an independent program with steps
// of 1e-3, off by 1e-6 (velocity Verlet), is near.
TEST(EventDriven, KeepsItsToleranceThroughEvents) {
    const Machine machine{.kappas = set_b()};
    const double rest = static_displacement(machine);
    const auto z_at_ten = [&](double step_tolerance) {
        EventDriven run(machine, motion_at_start(machine), step_tolerance);
        run.advance_to(10);
        return run.motion().z / rest;
    };
    const double finest = z_at_ten(1e-14);
    for (const double coarse : {1e-8, 1e-10, 1e-12})
        EXPECT_NEAR(z_at_ten(coarse), finest, 300 * coarse);
    EXPECT_NEAR(finest, -1.981489490, 5e-6);
}

// Far beyond small rotations the moments grow with phi squared: phi is infinite after finite time.
TEST(EventDriven, SaysWhereItCannotGoOn) {
    const Machine machine{.kappas = set_b()};
    EventDriven run(machine, motion_at_start(machine, {.phi = 1e5}), tolerance);
    try {
        run.advance_to(1000);
        FAIL() << "no error";
    } catch (const contact::NotConverged& error) {
        EXPECT_NE(std::string(error.what()).find("event-driven integration: at t ="),
                  std::string::npos)
            << error.what();
    }
}

TEST(EventDriven, RefusesStartsThatAreNone) {
    const Machine machine{.kappas = set_b()};
    Motion start = motion_at_start(machine);
    EXPECT_THROW(EventDriven(machine, start, 1e-2), std::invalid_argument);
    start.spots[0].tangential = start.spots[0].normal;  // bound: 0.68 * 1.2 of that
    EXPECT_THROW(EventDriven(machine, start, tolerance), std::invalid_argument);
    start.spots.pop_back();
    EXPECT_THROW(EventDriven(machine, start, tolerance), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::walking::event_driven_test

#include "walking/machine/linear_stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "tests/unit/walking/sets.h"
#include "walking/machine/event_driven.h"
#include "walking/machine/motion.h"
#include "walking/machine/velocity_verlet.h"

namespace tricontact::walking::linear_stability_test {
namespace {

// The weight ahead of the middle of the base: an unsymmetric machine, all scales different from 1.
Machine off_centre() {
    return {
        .kappas = set_b(), .model = Machine::Model::spots, .spots = {{-0.7, 0, 1}, {1.3, 0, 0.9}}};
}

using Matrix = std::vector<std::vector<double>>;

/// Differences of the accelerations at a sliding motion: of x, z, phi, then of what turns on the
/// flanks of a prism.
Matrix differences(const Machine& machine, const Motion& at) {
    const double h = 1e-4 * static_displacement(machine);
    const bool prism = machine.model == Machine::Model::prism;
    const std::size_t n_turning = prism ? at.spots.size() : 0;
    Matrix rows(3, std::vector<double>(3 + n_turning));
    for (std::size_t j = 0; j < 3 + n_turning; ++j) {
        const auto moved = [&](double by) {
            Motion motion =
                sliding_motion(machine, at.z + (j == 1 ? by : 0), at.phi + (j == 2 ? by : 0));
            motion.base = at.base;
            motion.x = j == 0 ? by : 0;
            if (j > 2) motion.spots[j - 3].flank = by;
            return acceleration(machine, spots_of(machine), motion);
        };
        const Acceleration ahead = moved(h), behind = moved(-h);
        rows[0][j] = (ahead.x - behind.x) / (2 * h);
        rows[1][j] = (ahead.z - behind.z) / (2 * h);
        rows[2][j] = (ahead.phi - behind.phi) / (2 * h);
    }
    return rows;
}

/// Of positions, velocities and what turns: a flank's deflection follows z - p phi/kappa3 over
/// sqrt(2), and slip at kappa6 turns it back.
Matrix system_of(const Machine& machine, const Motion& at) {
    const Matrix rows = differences(machine, at);
    const std::size_t n_turning = rows[0].size() - 3, n = 6 + n_turning;
    Matrix system(n, std::vector<double>(n));
    for (std::size_t i = 0; i < 3; ++i) {
        system[i][3 + i] = 1;
        for (std::size_t j = 0; j < rows[i].size(); ++j)
            system[3 + i][j < 3 ? j : 3 + j] = rows[i][j];
    }
    const auto spots = spots_of(machine);
    for (std::size_t i = 0; i < n_turning; ++i) {
        std::vector<double>& row = system[6 + i];
        row[4] = 1 / std::sqrt(2.);
        row[5] = -spots[i].position / machine.kappas.kappa3 / std::sqrt(2.);
        row[6 + i] = -machine.kappas.kappa6 / at.spots[i].tangential;
    }
    return system;
}

/// Sums of the powers of the eigenvalues, which are the traces of the matrix' powers, tell a
/// matrix' characteristic polynomial. Displacements so large that the terms of second order in phi
/// count.
TEST(SlidingEigenvalues, AreThoseOfTheDerivativesOfTheAcceleration) {
    Machine rounded = off_centre();
    rounded.kappas.kappa4 = 0.1;
    for (Spot& spot : rounded.spots) spot.offset = 0.05, spot.tip_radius = 0.3;
    Machine prism{.kappas = rounded.kappas, .model = Machine::Model::prism};
    Machine uncoupled = off_centre();
    uncoupled.mechanisms.coupling = false;
    for (const Machine& machine : {off_centre(), rounded, prism, uncoupled}) {
        const double rest = static_displacement(machine);
        const Motion at = sliding_motion(machine, 1.1 * rest, 0.07 * rest);
        const Matrix system = system_of(machine, at);
        const std::size_t n = system.size();
        const auto eigenvalues = sliding_eigenvalues(machine, at);
        ASSERT_EQ(eigenvalues.size(), n);
        Matrix power = system;
        for (std::size_t k = 1; k <= n; ++k) {
            double trace = 0, size = 1;
            std::complex<double> sum = 0;
            for (std::size_t i = 0; i < n; ++i) trace += power[i][i];
            for (const std::complex<double>& value : eigenvalues) {
                sum += std::pow(value, static_cast<double>(k));
                size += std::pow(std::abs(value), static_cast<double>(k));
            }
            // Quadratic in the displacements but for products of three: h^2.
            EXPECT_NEAR(sum.real(), trace, 1e-6 * size) << k;
            Matrix next(n, std::vector<double>(n));
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j)
                    for (std::size_t l = 0; l < n; ++l) next[i][j] += power[i][l] * system[l][j];
            power = next;
        }
    }
}

// Wetter (2016), eq. 4.2.13; in the prism the friction is sqrt(2) as large.
TEST(SteadySliding, EndsAtTheCriticalFriction) {
    for (const double kappa3 : {0.4, 1.3})
        for (const double kappa8 : {-0.6, 0.2, 1.2})
            for (const auto model : {Machine::Model::two_spot, Machine::Model::prism}) {
                Machine machine{.kappas = set_b(), .model = model};
                machine.kappas.kappa3 = kappa3, machine.kappas.kappa8 = kappa8;
                const double critical =
                    critical_friction(machine.kappas) / normal_load_factor(machine);
                // The critical friction leaves out moments of second order in phi.
                const double second_order = 20 * machine.kappas.kappa4;
                machine.kappas.kappa5 = critical * (1 - second_order);
                const auto below = steady_sliding(machine);
                ASSERT_TRUE(below);
                EXPECT_LT(below->spots[0].normal, 0.01 * below->spots[1].normal);
                machine.kappas.kappa5 = critical * (1 + second_order);
                EXPECT_FALSE(steady_sliding(machine));
            }
}

// Normal forces from the moments about the centre of gravity, without those of second order:
// N2 - N1 = mu kappa3 (1 + kappa8) kappa4.
TEST(SteadySliding, LoadsTheLeadingSpot) {
    const Machine machine{.kappas = set_b()};
    const Kappas& k = machine.kappas;
    const auto motion = steady_sliding(machine);
    ASSERT_TRUE(motion);
    const double difference = k.kappa2 * (motion->spots[1].normal - motion->spots[0].normal);
    EXPECT_NEAR(difference / (k.kappa5 * k.kappa3 * (1 + k.kappa8) * k.kappa4), 1, 10 * k.kappa4);
    EXPECT_NEAR(spring_force(machine, *motion) / (k.kappa5 * k.kappa4), 1, 1e-12);
    const Acceleration rest = acceleration(machine, spots_of(machine), *motion);
    EXPECT_NEAR(rest.z / k.kappa4, 0, 1e-13);
    EXPECT_NEAR(rest.phi / k.kappa4, 0, 1e-13);
}

// Alike spots at both ends: z vibrates on its own at sqrt(2 kappa2), and x and phi without friction
// to drive them, so that no friction coefficient gives growth. Set A and set B alike.
TEST(LinearStability, IsNeutralForSymmetricSpots) {
    for (const Kappas& kappas : {set_a(), set_b()}) {
        const Machine machine{.kappas = kappas};
        const auto motion = steady_sliding(machine);
        ASSERT_TRUE(motion);
        const auto values = sliding_eigenvalues(machine, *motion);
        ASSERT_EQ(values.size(), 6u);
        double nearest = 1;
        for (const auto& value : values) {
            EXPECT_NEAR(value.real(), 0, 1e-12);
            nearest = std::min(nearest, std::abs(value.imag() - std::sqrt(2 * kappas.kappa2)));
        }
        EXPECT_NEAR(nearest, 0, 1e-12);
        EXPECT_FALSE(flutter_friction(machine, critical_friction(kappas)));
    }
    // Pulled at its centre of gravity without rotation, x vibrates on the spring alone.
    Machine block{.kappas = set_a(), .mechanisms = {.vertical = false, .rotation = false}};
    const auto values = sliding_eigenvalues(block, *steady_sliding(block));
    ASSERT_EQ(values.size(), 2u);
    EXPECT_NEAR(std::abs(values[0].imag()), std::sqrt(block.kappas.kappa1), 1e-12);
}

// A soft spring leaves z and phi to themselves: the discriminant of their characteristic equation,
// (S0 - (S2 - mu kappa3 S1)/kappa7)^2 + 4 S1 (S1 - mu kappa3 S0)/kappa7, S_n = sum s p^n, is zero.
TEST(LinearStability, FluttersAboveTheFrictionOfTheClosedForm) {
    Machine machine = off_centre();
    Kappas& k = machine.kappas;
    k.kappa1 = 1e-9, k.kappa4 = 1e-9, k.kappa8 = 0;
    double s0 = 0, s1 = 0, s2 = 0;
    for (const auto& [position, height, stiffness, offset, radius] : machine.spots)
        s0 += stiffness, s1 += stiffness * position, s2 += stiffness * position * position;
    // With m = mu kappa3/kappa7: a m^2 + b m + c = 0, of which the smaller root is the onset.
    const double difference = s0 - s2 / k.kappa7;
    const double a = s1 * s1, b = 2 * s1 * (difference - 2 * s0),
                 c = difference * difference + 4 * s1 * s1 / k.kappa7;
    const double onset = (-b - std::sqrt(b * b - 4 * a * c)) / (2 * a) * k.kappa7 / k.kappa3;
    const auto found = flutter_friction(machine, 2);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found / onset, 1, 1e-6);
}

// Rate and frequency of a signal e^(rate t) cos(omega t + c) from four samples `interval` apart:
// s(t + 2 h) = 2 e^(rate h) cos(omega h) s(t + h) - e^(2 rate h) s(t).
std::complex<double> oscillation(const std::array<double, 4>& s, double interval) {
    const double determinant = s[1] * s[1] - s[0] * s[2];
    const double sum = (s[1] * s[2] - s[0] * s[3]) / determinant;
    const double product = (s[2] * s[2] - s[1] * s[3]) / determinant;
    return std::log(std::complex(sum / 2, std::sqrt(product - sum * sum / 4))) / interval;
}

// z of a run about its mean, at four times a quarter of a period apart.
template <class Z>
std::complex<double> measured(const Z& z_at, double mean, double time, double quarter) {
    std::array<double, 4> samples{};
    for (int i = 0; i < 4; ++i) samples[i] = z_at(time + i * quarter) - mean;
    return oscillation(samples, quarter);
}

// What the eigenvalues say happens in runs, by both integrators. The disturbance is so small that
// all spots go on slipping; the leading mode is measured when it is e^9 times the others.
void expect_in_runs(const Machine& machine, double disturbance, double time) {
    const auto steady = steady_sliding(machine);
    ASSERT_TRUE(steady);
    const std::complex<double> leading = leading_eigenvalue(machine, *steady);
    Motion start = *steady;
    start.phi_velocity = disturbance * static_displacement(machine);
    const double quarter = std::numbers::pi / 2 / leading.imag();
    time = std::ceil(time / quarter) * quarter;
    EventDriven reference(machine, start, 1e-13);
    VelocityVerlet verlet(machine, start, quarter / 500);
    const auto reference_z = [&](double t) {
        reference.advance_to(t);
        return reference.motion().z;
    };
    const auto verlet_z = [&](double t) {
        while (verlet.motion().time < t - verlet.step() / 2) verlet.advance();
        return verlet.motion().z;
    };
    for (const std::complex<double> found : {measured(reference_z, steady->z, time, quarter),
                                             measured(verlet_z, steady->z, time, quarter)}) {
        EXPECT_NEAR(found.real() / leading.real(), 1, 0.01);
        EXPECT_NEAR(found.imag() / leading.imag(), 1, 0.01);
    }
}

TEST(LinearStability, TellsHowRunsFlutter) {
    Machine machine = off_centre();
    machine.kappas.kappa5 = 0.6, machine.kappas.kappa8 = 0.8;
    const double rate = leading_eigenvalue(machine, *steady_sliding(machine)).real();
    ASSERT_GT(rate, 0.1);
    expect_in_runs(machine, 1e-8, 9 / rate);
}

// In the prism slip on the flanks turns, which damps set B's modes: sliding is stable. The others
// with this friction decay three times as fast as the leading one.
TEST(LinearStability, TellsHowRunsDecayInThePrism) {
    Machine machine{.kappas = set_b(), .model = Machine::Model::prism};
    machine.kappas.kappa5 = 0.2;
    const double rate = leading_eigenvalue(machine, *steady_sliding(machine)).real();
    ASSERT_LT(rate, -0.01);
    expect_in_runs(machine, 1e-2, 4.5 / -rate);
}

// On its leading spot alone, balanced at the critical friction, the body falls over: a real
// eigenvalue, of the order of sqrt(kappa4), since only moments of second order in phi turn it.
TEST(LinearStability, TellsHowRunsDiverge) {
    Machine machine{.kappas = set_b(), .model = Machine::Model::spots, .spots = {{.position = 1}}};
    machine.kappas.kappa5 = critical_friction(machine.kappas);
    Motion start = sliding_motion(machine, static_displacement(machine), 0);
    const std::complex<double> leading = leading_eigenvalue(machine, start);
    ASSERT_GT(leading.real(), 1e-3);
    EXPECT_NEAR(leading.imag(), 0, 1e-12);
    start.phi_velocity = -1e-9 * machine.kappas.kappa4;
    EventDriven run(machine, start, 1e-13);
    const double time = 9 / leading.real();
    run.advance_to(time);
    const double before = run.motion().phi;
    run.advance_to(time + 1 / leading.real());
    EXPECT_NEAR(std::log(run.motion().phi / before), 1, 0.01);
}

}  // namespace
}  // namespace tricontact::walking::linear_stability_test

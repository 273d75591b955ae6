// The machine with rounded tips against the quasi-static models: one tip that rolls is the
// oscillating rolling contact of Wetter (2016), chapter 3; two that rock share their loads.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "tests/verification/mdr/roller.h"
#include "theory/rolling/oscillating_rolling.h"
#include "walking/machine/machine.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/machine/walk_case.h"
#include "walking/run/walk.h"
#include "walking/run/walk_judge.h"

namespace tricontact::dynamics_bed_test {
namespace {

using namespace walking;

// A rocker on one tip whose centre of curvature is above the centre of gravity. A long soft spring
// at the height of the ground pulls with constant force and without a moment.
class Rocker {
  public:
    /// `slowness`: frequency of the rocking body over that of its excitation.
    Rocker(double w, double f, int springs, double slowness) : w_(w), f_(f) {
        machine_ = {.kappas = {1e-6, 1.2, 0.5, 1e-2, 0.5, 0, 0.42, -1},
                    .model = Machine::Model::spots,
                    .spots = {{}},
                    .bed = Bed{.radius = 2, .springs = springs}};
        const Kappas& k = machine_.kappas;
        depth_ = resting_indentation(k.kappa4 / k.kappa2);
        rotation_ = w * std::sqrt(depth_ / machine_.bed->radius);  // W = R Phi = w a
        // Moments about the contact: weight and the spring's end, at +b, against the excitation.
        const double stiffness = k.kappa4 * (machine_.bed->radius - k.kappa3 + f * k.kappa5);
        const double inertia = k.kappa7 + k.kappa3 * k.kappa3;  // about the contact
        frequency_ = std::sqrt(stiffness / inertia) / slowness;
        machine_.excitation = {.moment = stiffness * rotation_, .frequency = frequency_};
    }

    /// Shift x + phi over U_max after each of these periods.
    std::vector<double> shifts(int n_periods) const {
        const Kappas& k = machine_.kappas;
        const double unit = k.kappa5 * k.kappa2 * depth_,
                     period = 2 * std::numbers::pi / frequency_;
        VelocityVerlet run(machine_, pulled(unit), 0.05);
        std::vector<double> shifts;
        for (int i = 1; i <= n_periods; ++i) {
            while (run.motion().time < i * period) run.advance();
            shifts.push_back((run.motion().x + run.motion().phi) / unit);
        }
        return shifts;
    }

  private:
    // At rest under the pull, with the velocity of slow rocking: nothing vibrates but by inertia.
    Motion pulled(double unit) const {
        const Kappas& k = machine_.kappas;
        Motion motion = motion_at_start(machine_);
        const double shift = unit * (1 - std::pow(1 - f_, 2. / 3));
        for (SpotDeflection& spring : motion.spots)
            spring.tangential = std::min(shift, k.kappa5 * k.kappa2 * spring.normal);
        motion.x = shift;
        motion.base = shift + f_ * k.kappa5 * k.kappa4 / k.kappa1;
        motion.phi_velocity = k.kappa3 * rotation_ * frequency_;
        motion.x_velocity = -motion.phi_velocity;  // the tip rolls
        return motion;
    }

    double w_, f_, depth_ = 0, rotation_ = 0, frequency_ = 0;
    Machine machine_;
};

// Inertia makes the amplitude larger by slowness^-2, and the settled shift follows.
TEST(DynamicBed, RollsIntoTheSettledShiftAsItSlowsDown) {
    const double w = 0.24, f = 0.56, exact = *theory::settled_shift_ratio(w, f);
    const auto error = [&](double slowness) {
        return std::abs(Rocker(w, f, 385, slowness).shifts(8).back() - exact);
    };
    const double fast = error(5), medium = error(10), slow = error(20);
    EXPECT_GT(fast, medium);
    // Slips excite vibrations that nothing damps, of every phase: an order of two in the mean.
    EXPECT_NEAR(std::log2(fast / slow) / 2, 2, 0.4);
    EXPECT_LT(slow, 2e-3);
}

TEST(DynamicBed, SettlesBelowTheShakedownLimitAndRatchetsAbove) {
    for (const double f : {0.3, 0.72}) {
        const double limit = theory::amplitude_limit(f);
        // 5 %: what inertia adds to the amplitude at this slowness, and then some
        const auto below = Rocker(0.95 * limit, f, 192, 10).shifts(24),
                   above = Rocker(1.05 * limit, f, 192, 10).shifts(24);
        const auto drift = [](const std::vector<double>& shifts) {
            return (shifts[23] - shifts[11]) / 12;
        };
        EXPECT_LT(std::abs(drift(below)), 1e-3) << f;
        EXPECT_GT(drift(above), 0.02) << f;
    }
}

TEST(DynamicBed, RatchetsAsTheSpringBedOfMdr) {
    for (const auto& [w, f] : {std::pair{0.51, 0.72}, std::pair{0.24, 0.80}}) {
        mdr_test::Roller roller(mdr_test::sphere_rig(w, f, 1000, 60));
        const double quasi_static = roller.roll(12).increment_ratio();
        const auto shifts = Rocker(w, f, 385, 20).shifts(6);
        // Each slip feeds vibrations of the load, which help the next: some percent more.
        const double increment = (shifts[5] - shifts[1]) / 4;
        EXPECT_GT(increment, 0.99 * quasi_static) << w << ' ' << f;
        EXPECT_LT(increment, 1.06 * quasi_static) << w << ' ' << f;
    }
}

// Two tips that rock lose contact where the moment reaches half the weight times the base, and hold
// what they hold at their least loads; 5 % for what inertia and the start add.
TEST(DynamicBed, ShakesDownRatchetsAndWalksAsTheMomentGrows) {
    for (const double f : {0.3, 0.5}) {
        WalkCase rocking;
        rocking.machine = {.kappas = {1e-6, 1.2, 0.5, 1e-4, 0.68, 0, 0.42, -1},
                           .bed = Bed{.radius = 0.05, .springs = 48}};
        const Kappas& k = rocking.machine.kappas;
        const double frequency = 0.05;
        rocking.start.base =
            f * k.kappa5 * k.kappa4 / k.kappa1 / static_displacement(rocking.machine);
        rocking.time = {.step = 0.02, .end = 40 * 2 * std::numbers::pi / frequency};
        const auto run = [&](double ratio) {
            rocking.machine.excitation = {.moment = ratio * k.kappa4, .frequency = frequency};
            return walk(rocking).result;
        };
        const DriftLimits limits = drift_limits(rocking.machine, f);
        const double settled = 0.95 * limits.ratcheting, moving = 1.05 * limits.ratcheting;
        EXPECT_EQ(run(settled).regime, Regime::shakedown) << f;
        EXPECT_EQ(run(moving).regime, Regime::ratcheting) << f;
        EXPECT_GT(run(moving).drift->per_period, 0.05) << f;
        EXPECT_EQ(run(0.95 * limits.lift_off).regime, Regime::ratcheting) << f;
        EXPECT_EQ(run(1.02 * limits.lift_off).regime, Regime::walking) << f;
    }
}

}  // namespace
}  // namespace tricontact::dynamics_bed_test

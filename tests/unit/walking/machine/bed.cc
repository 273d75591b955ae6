#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/unit/walking/sets.h"
#include "theory/cattaneo_mindlin.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::bed_test {
namespace {

// Beds over three contact diameters; the odd one has a spring under the tip.
constexpr std::array n_springs = {48, 97, 192};
constexpr double load = 1e-4;
constexpr double depth = 1.5 * load;  // Hertz: F = 2/3 k_z d

Bed bed(int springs) {
    return {.radius = 2, .springs = springs};
}

// A rounded tip, pressed from the air to this depth, upright.
struct Pressed {
    std::vector<Spot> springs;
    std::vector<SpotDeflection> deflections;

    Pressed(int n, double z) : springs(bed_springs(bed(n), {}, load)), deflections(n) {
        for (int i = 0; i < n; ++i) advance_flat(deflections[i], approach(springs[i], z, 0), 0, 0);
    }
    double normal_force() const {  // over k_z b
        double sum = 0;
        for (std::size_t i = 0; i < springs.size(); ++i)
            sum += springs[i].stiffness * deflections[i].normal;
        return sum;
    }
    /// Moves the body by this and tells the tangential force over k_x b.
    double shift(double increment, double bound_ratio) {
        double sum = 0;
        for (std::size_t i = 0; i < springs.size(); ++i) {
            SpotDeflection& deflection = deflections[i];
            advance_flat(deflection, deflection.normal, bound_ratio * deflection.normal, increment);
            sum += springs[i].stiffness * deflection.tangential;
        }
        return sum;
    }
};

// The midpoint rule errs where the contact ends, by up to 3/8 (spacing/contact radius)^2 of the
// force, more or less by where the ends fall in their cells: an order between 1 and 3 over a factor
// of four. `radius_squared` of the contact, over that at rest.
template <class Error>
void expect_second_order(double radius_squared, Error error) {
    const double coarse = error(n_springs.front()), fine = error(n_springs.back());
    constexpr double spacing = 6. / n_springs.back();  // the bed is three diameters wide
    EXPECT_LT(fine, 0.375 * spacing * spacing / radius_squared);
    EXPECT_GT(coarse / fine, 4);
    EXPECT_LT(coarse / fine, 64);
    EXPECT_LT(error(n_springs[1]), coarse);
}

TEST(Bed, CarriesByHertz) {
    for (const double ratio : {0.37, 1.9, 4.3}) {
        expect_second_order(ratio, [&](int n) {
            const double hertz = load * std::pow(ratio, 1.5);
            return std::abs(Pressed(n, ratio * depth).normal_force() / hertz - 1);
        });
    }
}

TEST(Bed, StandsAtHertzIndentation) {
    Kappas kappas = set_b();
    const double share = kappas.kappa4 / 2 / kappas.kappa2;
    for (const int n : n_springs) {
        const Machine machine{.kappas = kappas, .bed = bed(n)};
        const double rest = static_displacement(machine);
        // The rule's error of the force, two thirds of it in the depth.
        EXPECT_NEAR(rest / resting_indentation(share), 1, 1.0 / n / n * 9);
        // At rest its springs' stiffnesses add up to k_z: as many cells as D_c is long.
        double stiffness = 0;
        for (const Spot& spring : springs_of(machine))
            if (approach(spring, rest, 0) > 0) stiffness += spring.stiffness / 2;
        EXPECT_NEAR(stiffness, 1, 3.0 / n + 1e-12);
    }
}

TEST(Bed, SlipsInPartAsCattaneoAndMindlinSay) {
    constexpr double bound_ratio = 0.6;  // mu kappa2
    for (const double f : {0.15, 0.5, 0.9}) {
        expect_second_order(1, [&](int n) {
            Pressed tip(n, depth);
            const double force =
                tip.shift(theory::static_shift_ratio(f) * bound_ratio * depth, bound_ratio);
            return std::abs(force / (bound_ratio * load) - f);
        });
    }
}

TEST(Bed, SlidesUnderMuTimesItsNormalForceAndTurnsBack) {
    constexpr double bound_ratio = 0.6;
    Pressed tip(96, depth);
    const double limit = bound_ratio * tip.normal_force();
    EXPECT_NEAR(tip.shift(2 * bound_ratio * depth, bound_ratio) / limit, 1, 1e-14);
    // Back by as much as it was loaded: Masing, every spring slides twice its bound.
    EXPECT_NEAR(tip.shift(-2 * bound_ratio * depth, bound_ratio) / limit, -1, 1e-14);
}

// Turned by Phi, a tip is the same paraboloid about -R Phi, R Phi^2/2 lower.
TEST(Bed, RollsByRadiusTimesRotation) {
    const Bed wide = bed(2000);
    const std::vector<Spot> springs = bed_springs(wide, {.position = -1}, load);
    const double radius = wide.radius, contact_radius = std::sqrt(radius * depth);
    for (const double w : {-0.9, 0.3, 1.2}) {
        const double rotation = w * contact_radius / radius;
        const double z = depth - rotation - radius / 2 * rotation * rotation;  // position -1
        double force = 0, moment = 0, left = 1, right = -1;
        for (const Spot& spring : springs) {
            const double n = std::max(0., approach(spring, z, rotation));
            force += spring.stiffness * n;
            moment += spring.stiffness * n * normal_lever(spring, rotation);
            if (n > 0) left = std::min(left, spring.offset), right = std::max(right, spring.offset);
        }
        // spacing 3e-3 a: force to its square, ends of the contact to one cell
        EXPECT_NEAR(force / load, 1, 1e-5) << w;
        EXPECT_NEAR((moment / force + 1) / contact_radius, -w, 1e-5) << w;
        EXPECT_NEAR(left / contact_radius, -w - 1, 3e-3) << w;
        EXPECT_NEAR(right / contact_radius, -w + 1, 3e-3) << w;
    }
}

TEST(Bed, LeverIsTheDerivativeOfTheApproach) {
    const Spot spring{.position = -0.7, .height = 1e-3, .offset = 0.02, .tip_radius = 3};
    constexpr double h = 1e-3, rotation = 0.013;  // a parabola's central difference is exact
    const double difference =
        (approach(spring, 0, rotation + h) - approach(spring, 0, rotation - h)) / (2 * h);
    EXPECT_NEAR(normal_lever(spring, rotation), -difference, 1e-12);
}

// One spring as wide as the contact under a tip of no radius is the single spring of Wetter (2016).
TEST(Bed, OfOneSpringIsTheTwoSpotMachine) {
    const Machine plain{.kappas = set_b()};
    Machine bedded = plain;
    bedded.bed = Bed{.radius = 0, .springs = 1, .width = 1};
    EXPECT_EQ(static_displacement(bedded), static_displacement(plain));
    VelocityVerlet reference(plain, motion_at_start(plain), 1e-3);
    VelocityVerlet run(bedded, motion_at_start(bedded), 1e-3);
    for (int step = 0; step < 20000; ++step) {  // some jumps
        reference.advance();
        run.advance();
    }
    EXPECT_EQ(run.motion(), reference.motion());
}

}  // namespace
}  // namespace tricontact::walking::bed_test

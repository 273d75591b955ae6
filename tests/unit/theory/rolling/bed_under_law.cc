#include "theory/rolling/bed_under_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/half_space_scales.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::theory::bed_under_law_test {
namespace {

using std::numbers::pi;

// The table has 512 pieces: errors of 512^-2 of the curvature.
constexpr double tolerance = 1e-6;

contact::Case sphere(const contact::Friction& friction) {
    contact::Case c;
    c.indenter.shape = contact::Case::Shape::paraboloid;
    c.indenter.radius = .04;
    c.substrate = {2e6, .5};
    c.load.normal_force = 3;
    c.load.tangential_ratio = .3;
    c.friction = friction;
    return c;
}

double strength_force(double u) {
    return 2 / pi * (u * std::sqrt(1 - u * u) + std::asin(u));
}

double strength_limit(double w) {
    return 2 / pi * (std::acos(w) - w * std::sqrt(1 - w * w));
}

TEST(BedUnderLaw, ShearStrengthHasItsClosedForms) {
    const contact::Case c = sphere({.shear_strength = 3e5});
    const BedUnderLaw bed(c);
    const double a = contact::half_space_scales(c).contact_radius;
    EXPECT_NEAR(bed.friction_limit() / (pi * a * a * 3e5), 1, tolerance);
    for (const double f : {.05, .3, .55, .9, .999})
        EXPECT_NEAR(strength_force(bed.static_shift_ratio(f)), f, tolerance);
    for (const double w : {0., .2, .4, .9})
        EXPECT_NEAR(bed.shakedown_limit(w), strength_limit(w), tolerance);
    EXPECT_NEAR(bed.amplitude_limit(strength_limit(.3)), .3, tolerance);
    // A lens of two circles has no simpler inverse: values of a simulation by springs, 5 digits.
    struct {
        double w, f, settled, from_rest;
    } const table[] = {{.2, .3, .30024, .23788},
                       {.2, .55, .58386, .44738},
                       {.4, .2, .26715, .15774},
                       {.4, .35, .49270, .27853}};
    for (const auto& [w, f, settled, from_rest] : table) {
        EXPECT_NEAR(bed.static_shift_ratio(f), from_rest, 6e-6);
        const double u = *bed.settled_shift_ratio(w, f);
        EXPECT_NEAR(u, settled, 6e-6);
        EXPECT_NEAR(strength_force(u) - 4 / pi * w * u, f, tolerance);
    }
    EXPECT_FALSE(bed.settled_shift_ratio(.2, strength_limit(.2) + 1e-5));
}

// Coulomb's law by the same tables, beside Cattaneo, Mindlin and the thesis' closed forms.
TEST(BedUnderLaw, NearCoulombsLawItHasThatOnesForms) {
    const BedUnderLaw bed(sphere({.coefficient = .5, .strength_limit = 1e12}));
    for (const double f : {.1, .5, .9})
        EXPECT_NEAR(bed.static_shift_ratio(f), theory::static_shift_ratio(f), 2e-6);
    for (const double w : {.1, .5}) {
        EXPECT_NEAR(bed.shakedown_limit(w), theory::shakedown_limit(w), tolerance);
        const double f = .6 * theory::shakedown_limit(w);
        EXPECT_NEAR(*bed.settled_shift_ratio(w, f), *theory::settled_shift_ratio(w, f), 2e-6);
    }
}

// Limits of a sum of laws are sums: F_lim = tau_0 pi a^2 lens + mu F_N (1 - 3w/2 + w^3/2).
TEST(BedUnderLaw, SumsOfLawsHaveSumsOfLimits) {
    const contact::Case c = sphere({.coefficient = .3, .shear_strength = 1e5});
    const BedUnderLaw bed(c);
    const auto s = contact::half_space_scales(c);
    const double of_strength = 1e5 * pi * s.contact_radius * s.contact_radius,
                 of_pressure = .3 * s.normal_force;
    EXPECT_NEAR(bed.friction_limit() / (of_strength + of_pressure), 1, tolerance);
    EXPECT_NEAR(s.friction_limit / (of_strength + of_pressure), 1, tolerance);
    // U_max of the sum: b(0) = 2 tau_0 a + mu E* d.
    EXPECT_NEAR(
        s.unit_shift * c.materials().effective_shear_modulus() /
            (2e5 * s.contact_radius + .3 * c.materials().effective_modulus() * s.indentation),
        1, tolerance);
    for (const double w : {.2, .7})
        EXPECT_NEAR(
            bed.shakedown_limit(w) * bed.friction_limit() /
                (of_strength * strength_limit(w) + of_pressure * (1 - 1.5 * w + w * w * w / 2)),
            1, tolerance);
}

// tau = mu p_r (p/p_r)^n on Hertz' pressure: with p ~ y the limit is the integral of y^n over the
// disc, mu p_r pi a^2 (p0/p_r)^n 2/(n + 2).
TEST(BedUnderLaw, PowersOfThePressureCarryTheirIntegral) {
    for (const double n : {.5, 2. / 3, .9, 1.5}) {
        const contact::Case c =
            sphere({.coefficient = .4, .pressure_exponent = n, .reference_pressure = 2e5});
        const auto s = contact::half_space_scales(c);
        const double area = pi * s.contact_radius * s.contact_radius;
        const double limit = .4 * 2e5 * std::pow(s.peak_pressure / 2e5, n) * area * 2 / (n + 2);
        // p^n is not smooth at the edge: the order of the table is n + 1 there.
        EXPECT_NEAR(BedUnderLaw(c).friction_limit() / limit, 1, 1e-5) << n;
        EXPECT_NEAR(s.friction_limit / limit, 1, 2e-4) << n;
    }
}

}  // namespace
}  // namespace tricontact::theory::bed_under_law_test

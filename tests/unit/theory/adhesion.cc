#include "theory/adhesion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::theory::adhesion_test {
namespace {

using std::numbers::pi;

constexpr double radius = 12e-3, modulus = 4e6, work = 80e-3;

// Hertz' pressure less that of a flat punch whose energy release rate is w: a second way to JKR,
// F = 4 E* a^3/(3 R) - sqrt(8 pi w E* a^3) (Johnson 1985, eq. 5.48).
TEST(Adhesion, JkrIsHertzLessAFlatPunch) {
    for (const double force : {-4e-3, 0., 1e-2, 3.}) {
        const double a = adhesive_contact_radius(Adhesion::jkr, force, radius, modulus, work);
        EXPECT_NEAR(
            4 * modulus * a * a * a / (3 * radius) - std::sqrt(8 * pi * work * modulus * a * a * a),
            force, 1e-12 * (1 + force));
    }
}

// At pull-off dF/da = 0: no larger force has a contact. 1e-4 off its radius the force differs by
// the square.
TEST(Adhesion, TheForceIsLeastWhereTheSphereComesOff) {
    const double off = pull_off_force(Adhesion::jkr, radius, work);
    EXPECT_DOUBLE_EQ(off, 1.5 * pi * work * radius);
    const double a = adhesive_contact_radius(Adhesion::jkr, -off, radius, modulus, work);
    const auto force = [](double x) {
        return 4 * modulus * x * x * x / (3 * radius) -
               std::sqrt(8 * pi * work * modulus * x * x * x);
    };
    EXPECT_NEAR(force(a), -off, 1e-12);
    EXPECT_GT(force(a * 1.0001), force(a));
    EXPECT_GT(force(a * .9999), force(a));
    EXPECT_THROW(adhesive_contact_radius(Adhesion::jkr, -1.001 * off, radius, modulus, work),
                 std::domain_error);
    // Of DMT nothing is left of the contact there.
    EXPECT_EQ(adhesive_contact_radius(Adhesion::dmt, -pull_off_force(Adhesion::dmt, radius, work),
                                      radius, modulus, work),
              0);
}

// Large forces: Hertz' radius, and JKR's first term, 1 + sqrt(6 pi w R/F)/3.
TEST(Adhesion, VanishesUnderLargeForces) {
    const double hertz = std::cbrt(3 * radius * 1e6 / (4 * modulus));
    const double jkr = adhesive_contact_radius(Adhesion::jkr, 1e6, radius, modulus, work) / hertz;
    EXPECT_NEAR((jkr - 1) / (std::sqrt(6 * pi * work * radius / 1e6) / 3), 1, 1e-3);
    EXPECT_NEAR(adhesive_contact_radius(Adhesion::dmt, 1e6, radius, modulus, work) / hertz, 1,
                1e-8);
}

// A sphere on rubber is JKR, a stiff one of 0.1 um DMT; the parameter goes with R^(1/3) w^(2/3).
TEST(Adhesion, TaborsParameterTellsTheTheory) {
    const double tabor = tabor_parameter(radius, work, modulus, .3e-9);
    EXPECT_GT(tabor, 1000);
    EXPECT_NEAR(tabor_parameter(8 * radius, work, modulus, .3e-9) / tabor, 2, 1e-12);
    EXPECT_NEAR(tabor_parameter(radius, 8 * work, modulus, .3e-9) / tabor, 4, 1e-12);
    EXPECT_LT(tabor_parameter(1e-7, 30e-3, 1e11, .3e-9), .1);
    EXPECT_THROW(tabor_parameter(radius, 0, modulus, .3e-9), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::adhesion_test

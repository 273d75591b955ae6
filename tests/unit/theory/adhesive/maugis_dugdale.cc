// Maugis' transition by its limits and by what others fitted to it.

#include "theory/adhesive/maugis_dugdale.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tricontact::maugis_dugdale_test {

// Johnson, Kendall and Roberts: P = A^3 - sqrt(6 A^3), D = A^2 - 2/3 sqrt(6 A), pull-off 3/2; the
// ring has the width of O(1/lambda^2).
TEST(MaugisDugdale, OfALargeLambdaIsShortRanged) {
    const double lambda = 1e3;
    for (const double a : {.8, 1.5, 3.}) {
        const auto s = theory::maugis_contact(lambda, a);
        EXPECT_NEAR(s.force, std::pow(a, 3) - std::sqrt(6 * std::pow(a, 3)), 1e-3);
        EXPECT_NEAR(s.indentation, a * a - 2. / 3 * std::sqrt(6 * a), 1e-3);
    }
    EXPECT_NEAR(theory::maugis_pull_off(lambda).force, -1.5, 1e-5);
}

// Derjaguin, Muller and Toporov: P = A^3 - 2, D = A^2.
TEST(MaugisDugdale, OfASmallLambdaIsLongRanged) {
    const auto s = theory::maugis_contact(1e-6, 1.5);
    EXPECT_NEAR(s.force, std::pow(1.5, 3) - 2, 1e-2);
    EXPECT_NEAR(s.indentation, 2.25, 1e-2);
    EXPECT_NEAR(theory::maugis_pull_off(1e-6).force, -2, 1e-2);
}

// Carpick, Ogletree and Salmeron (1999, J. Colloid Interface Sci. 211, 395) fitted the pull-off of
// his equations within some 1 %: P = -7/4 + 1/4 (4.04 l^1.4 - 1)/(4.04 l^1.4 + 1), and the radius
// at P = 0, 1.54 + .279 (2.28 l^1.3 - 1)/(2.28 l^1.3 + 1).
TEST(MaugisDugdale, BetweenIsAsFitted) {
    for (const double lambda : {.1, .5, 1., 3.}) {
        const double p = 4.04 * std::pow(lambda, 1.4), a = 2.28 * std::pow(lambda, 1.3);
        EXPECT_NEAR(theory::maugis_pull_off(lambda).force / (-1.75 + .25 * (p - 1) / (p + 1)), 1,
                    .015);
        EXPECT_NEAR(
            theory::maugis_contact_under(lambda, 0).radius / (1.54 + .279 * (a - 1) / (a + 1)), 1,
            .015);
    }
}

// lambda = 1.16 mu of Tabor's parameter, sigma_0 z_0 = .97 w of Lennard and Jones (Maugis 1992);
// here of sigma_0 = w/z_0: 1.16/1.03.
TEST(MaugisDugdale, ParameterIsOneOfTabors) {
    const double tabor = std::cbrt(2e-3 * .05 * .05 / (1e12 * 1e-24));
    EXPECT_NEAR(theory::maugis_parameter(2e-3, .05, 1e6, .05 / 1e-8) / tabor, 1.16 / 1.03, 5e-3);
}

}  // namespace tricontact::maugis_dugdale_test

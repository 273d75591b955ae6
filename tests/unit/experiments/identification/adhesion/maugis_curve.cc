// Many states of Maugis' contact at once, against his equations solved one by one, and the ends of
// the transition.

#include "experiments/identification/adhesion/maugis_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tricontact::experiments::maugis_curve_test {
namespace {

constexpr double radius = .01, modulus = 2.4e6, work = .05, pi = std::numbers::pi;

TEST(MaugisCurve, IsThatOfItsEquations) {
    const double k = 4. / 3 * modulus, unit = std::cbrt(pi * work * radius * radius / k);
    for (const double lambda : {.1, 1., 5.}) {
        MaugisCurve curve(radius, modulus, work,
                          MaugisCurve::range_of(lambda, radius, modulus, work));
        for (const double depth : {.2, 1., 4.}) {
            const auto exact = theory::maugis_contact_at(lambda, depth);
            EXPECT_NEAR(curve.force_at(depth * unit * unit / radius) / (pi * work * radius),
                        exact.force, 1e-7);
            EXPECT_NEAR(curve.radius_under(exact.force * pi * work * radius) / unit, exact.radius,
                        1e-7);
        }
        // Below the branch, its end.
        EXPECT_NEAR(curve.force_at(2 * curve.last_indentation() - radius) / (pi * work * radius),
                    theory::maugis_pull_off(lambda).force, 1e-4);
    }
}

// 3/2 pi w R and 2 pi w R.
TEST(MaugisCurve, ComesToBothTheories) {
    const auto pull_off = [](double lambda) {
        MaugisCurve curve(radius, modulus, work,
                          MaugisCurve::range_of(lambda, radius, modulus, work));
        return curve.force_at(-radius) / (pi * work * radius);
    };
    EXPECT_NEAR(pull_off(100), -1.5, 1e-3);
    EXPECT_NEAR(pull_off(1e-3), -2, 5e-3);
}

}  // namespace
}  // namespace tricontact::experiments::maugis_curve_test

#include "theory/cattaneo_mindlin.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>

namespace tricontact::cattaneo_mindlin_test {
namespace {

using namespace theory;
using boost::math::quadrature::gauss_kronrod;

TEST(CattaneoMindlin, TractionCarriesTheTangentialForce) {
    for (const double f : {0.1, 0.56, 0.9, 1.}) {
        auto ring = [&](double rho) { return rho * cattaneo_mindlin_traction(rho, f); };
        const double c = stick_radius_ratio(f);
        // F_T/(mu F_N) = ∫ tau 2 pi r dr / (2/3 pi a^2 mu p0); the integral is split at the kink
        const double force = 3 * (gauss_kronrod<double, 61>::integrate(ring, 0., c, 15, 1e-12) +
                                  gauss_kronrod<double, 61>::integrate(ring, c, 1., 15, 1e-12));
        // square root ends: Gauss-Kronrod reaches about 1e-11
        EXPECT_NEAR(force, f, 1e-10) << f;
    }
}

TEST(CattaneoMindlin, TractionIsTheBoundWhereItSlips) {
    const double f = 0.56, c = stick_radius_ratio(f);
    EXPECT_NEAR(c, std::cbrt(0.44), 1e-15);
    for (const double rho : {c, 0.9, 0.99})
        EXPECT_NEAR(cattaneo_mindlin_traction(rho, f), std::sqrt(1 - rho * rho), 1e-14);
    for (const double rho : {0., 0.3, 0.7})
        EXPECT_LT(cattaneo_mindlin_traction(rho, f), std::sqrt(1 - rho * rho));
    EXPECT_EQ(cattaneo_mindlin_traction(1.2, f), 0);
}

TEST(CattaneoMindlin, ShiftAtKnownPoints) {
    EXPECT_EQ(static_shift_ratio(0), 0);
    EXPECT_EQ(static_shift_ratio(1), 1);
    EXPECT_NEAR(static_shift_ratio(0.488), 0.36, 1e-15);  // 1 - f = 0.8^3
    EXPECT_NEAR(static_shift_ratio(7. / 8), 0.75, 1e-15);
    EXPECT_NEAR(static_shift_ratio(1e-12) / (2e-12 / 3), 1, 1e-11);  // no cancellation
}

// Work over a loop = ∮ F_T dU on the curve of Mindlin and Deresiewicz:
// unloading from f, U(F) = U(f) - 2 U((f - F)/2) in these units.
TEST(CattaneoMindlin, CycleDissipationIsTheAreaOfTheLoop) {
    const OscillatingForce unit{1, 4. / 3, 1, 1, 0};  // mu = E* = G* = R = d = 1
    for (const double f : {0.05, 0.3, 0.6, 0.9, 1.}) {
        auto unloading = [&](double force) {
            return static_shift_ratio(f) - 2 * static_shift_ratio((f - force) / 2);
        };
        // Central symmetry of the loop: its area is 2 ∫ U_unloading dF, F in units of 4/3.
        const double area =
            2 * 4. / 3 * gauss_kronrod<double, 61>::integrate(unloading, -f, f, 15, 1e-13);
        OscillatingForce load = unit;
        load.tangential_ratio = f;
        // the area is a difference of order f^3 of terms of order f
        EXPECT_NEAR(cycle_dissipation(load) / area, 1, 1e-9) << f;
    }
}

TEST(CattaneoMindlin, CycleDissipationAtKnownPoints) {
    const OscillatingForce unit{1, 4. / 3, 1, 1, 0};
    const double expected[][2] = {{0.3, 0.0066890}, {0.6, 0.0729909}, {0.9, 0.4279875}};
    for (const auto& [f, work] : expected) {
        OscillatingForce load = unit;
        load.tangential_ratio = f;
        EXPECT_NEAR(cycle_dissipation(load), work, 5.1e-8) << f;  // printed to seven decimals
    }
    // Units: W0 ~ mu^2 F_N^2/(G* a); at small f the braces are 5/162 f^3 (1 + 2/3 f ...).
    const OscillatingForce load{0.5, 20, 4e6, 3e-3, 1e-6};
    const double scale = 0.25 * 400 / (4e6 * 3e-3);
    EXPECT_NEAR(cycle_dissipation(load) / (scale * 18. / 5 * 5. / 162 * 1e-18), 1, 1e-6);
}

TEST(CattaneoMindlin, RefusesRatiosOutOfRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double f : {-0.1, 1.0001, nan}) {
        EXPECT_THROW(stick_radius_ratio(f), std::domain_error);
        EXPECT_THROW(static_shift_ratio(f), std::domain_error);
        EXPECT_THROW(cattaneo_mindlin_traction(0.5, f), std::domain_error);
        EXPECT_THROW(cycle_dissipation({1, 1, 1, 1, f}), std::domain_error);
    }
    EXPECT_THROW(cattaneo_mindlin_traction(-1, 0.5), std::domain_error);
    EXPECT_THROW(cycle_dissipation({0, 1, 1, 1, 0.5}), std::domain_error);
}

}  // namespace
}  // namespace tricontact::cattaneo_mindlin_test

#include "theory/rolling/oscillating_rolling.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "theory/cattaneo_mindlin.h"

namespace tricontact::oscillating_rolling_test {
namespace {

using namespace theory;
using boost::math::quadrature::gauss_kronrod;

double force_ratio(double w, double u, double kappa) {
    return 1 - kappa * w * u - std::pow(1 - u, 1.5);
}

TEST(OscillatingRolling, SettledShiftSolvesItsEquation) {
    for (const double kappa : {0.5, 1.0, 1.1, 1.5})
        for (const double w : {0., 0.05, 0.24, 0.51, 0.9})
            for (const double part : {0., 1e-9, 0.3, 0.9, 0.999, 1.}) {
                const double f = part * shakedown_limit(w, kappa);
                const auto u = settled_shift_ratio(w, f, kappa);
                ASSERT_TRUE(u) << w << ' ' << part;
                EXPECT_NEAR(force_ratio(w, *u, kappa), f, 4e-16) << w << ' ' << part;
                EXPECT_GE(*u, 0);
                EXPECT_LE(*u, 1 - w * w + 1e-15);
            }
}

TEST(OscillatingRolling, SettledShiftAtKnownPoints) {
    // Reference table (MDR column), four digits.
    EXPECT_NEAR(*settled_shift_ratio(.24, .24), .2284, 5e-5);
    EXPECT_NEAR(*settled_shift_ratio(.24, .56), .6520, 5e-5);
    EXPECT_NEAR(*settled_shift_ratio(.51, .09), .1315, 5e-5);
    EXPECT_NEAR(*settled_shift_ratio(.51, .24), .4281, 5e-5);
    EXPECT_DOUBLE_EQ(*settled_shift_ratio(0, .56), static_shift_ratio(.56));
    EXPECT_EQ(*settled_shift_ratio(1, 0), 0);
    EXPECT_EQ(*settled_shift_ratio(0, 1), 1);
}

TEST(OscillatingRolling, BeyondTheLimitNothingSettles) {
    for (const double kappa : {1.0, 1.1, 1.5}) {
        const double limit = shakedown_limit(.51, kappa);
        EXPECT_FALSE(settled_shift_ratio(.51, limit * (1 + 1e-12), kappa));
        EXPECT_NEAR(*settled_shift_ratio(.51, limit, kappa), 1 - .51 * .51, 1e-7);
    }
}

TEST(OscillatingRolling, MappingParameterInvertsTheShift) {
    for (const double kappa : {0.93, 1.1, 1.5})
        for (const double w : {0.1, 0.5, 0.9}) {
            const double f = 0.7 * shakedown_limit(w, kappa);
            const double u = *settled_shift_ratio(w, f, kappa);
            EXPECT_NEAR(mapping_parameter(w, f, u), kappa, 1e-14 / (w * u));  // rounding of f
        }
}

TEST(OscillatingRolling, LimitsAreTheSpecialCasesOfTheThesis) {
    for (const double w : {0., .1, .51, .9, 1.}) {
        EXPECT_NEAR(shakedown_limit(w), 1 - 1.5 * w + .5 * w * w * w, 1e-15);
        EXPECT_NEAR(shakedown_limit(w, 1.), 1 - w, 1e-15);
        EXPECT_NEAR(shakedown_limit(w, 1.1), 1 - 1.1 * w + .1 * w * w * w, 1e-15);
    }
    EXPECT_LT(.30, shakedown_limit(.51));  // (.51, .30) shakes down, (.51, .304) does not
    EXPECT_GT(.304, shakedown_limit(.51));
}

// The exact limit of uncoupled contact: (1/F_N) ∫ min p dA over the two turning points.
TEST(OscillatingRolling, LimitIsTheOverlapOfTheTwoPressures) {
    for (const double w : {.1, .51, .9}) {
        auto inner = [w](double x) {  // lens |x| + w < 1, half ellipse across: pi/2 (1-(|x|+w)^2)
            return std::numbers::pi / 2 * (1 - (x + w) * (x + w));
        };
        const double overlap = 2 * gauss_kronrod<double, 15>::integrate(inner, 0., 1 - w);
        EXPECT_NEAR(shakedown_limit(w), overlap / (2 * std::numbers::pi / 3), 1e-14);
    }
}

TEST(OscillatingRolling, AmplitudeLimitInverts) {
    for (const double kappa : {0.1, 1.0, 1.1, 1.5})
        for (const double f : {0., 1e-6, .3, .8, 1.}) {
            const double w = amplitude_limit(f, kappa);
            EXPECT_NEAR(shakedown_limit(w, kappa), f, 1e-15) << kappa << ' ' << f;
        }
    EXPECT_NEAR(amplitude_limit(.3, 1.), .7, 1e-15);
}

TEST(OscillatingRolling, ThresholdSlope) {
    EXPECT_NEAR(mdr_threshold_slope(5. / 16), 72. / 31, 1e-14);  // w_lim = 1/2
    EXPECT_EQ(mdr_threshold_slope(1), 4);                        // w_lim = 0
    EXPECT_EQ(mdr_threshold_slope(0), 0);                        // w_lim = 1
}

TEST(OscillatingRolling, ThesisIncrements) {
    // Reference values of the formula along the rolling: .046 at (.24, .80), .246 at (.51, .72).
    EXPECT_NEAR(thesis_increment_parallel(.24, .80), .046, 6e-4);
    EXPECT_NEAR(thesis_increment_parallel(.51, .72), .246, 6e-4);
    EXPECT_NEAR(thesis_increment_perpendicular(.51, .72),
                std::sqrt(5 * static_shift_ratio(.72)) * (.51 - amplitude_limit(.72, 1.1)), 1e-15);
    EXPECT_EQ(thesis_increment_parallel(.1, .8), 0);
    EXPECT_EQ(thesis_increment_perpendicular(.1, .8), 0);
}

/// Line load of MDR after shakedown over its largest bound mu E* d, at xi = x/a (any sign):
/// u in the stick zone, 1 - (|xi| + w)^2 in the slip zone, zero outside.
double mdr_shakedown_line_load(double xi, double w, double u) {
    const auto [stick, slip] = shakedown_zones(w, u);
    const double distance = std::abs(xi);
    if (distance <= stick) return u;
    return distance < slip ? (1 - w - distance) * (1 + w + distance) : 0;
}

TEST(OscillatingRolling, LineLoadAndTractionCarryTheForce) {
    for (const double w : {0., .24, .51})
        for (const double part : {.4, .9, 1.}) {
            const double f = part * shakedown_limit(w), u = *settled_shift_ratio(w, f);
            const auto [c, b] = shakedown_zones(w, u);
            auto line = [&](double x) { return mdr_shakedown_line_load(x, w, u); };
            auto ring = [&](double r) { return r * mdr_shakedown_traction(r, w, u); };
            using quadrature = gauss_kronrod<double, 61>;
            // F_T/(mu F_N): 2 ∫ q dx over 4/3, and ∫ tau 2 pi r dr over 2/3 pi; split at the kinks
            const double sum =
                quadrature::integrate(line, 0., c) + quadrature::integrate(line, c, b);
            const double area = quadrature::integrate(ring, 0., c, 15, 1e-12) +
                                quadrature::integrate(ring, c, b, 15, 1e-12);
            EXPECT_NEAR(1.5 * sum, f, 1e-13) << w << ' ' << part;
            EXPECT_NEAR(3 * area, f, 1e-9) << w << ' ' << part;  // square root ends
        }
}

TEST(OscillatingRolling, WithoutRollingTheTractionIsCattaneoMindlins) {
    const double f = .56, u = static_shift_ratio(f);
    for (const double rho : {0., .2, .75, .8, .95, 1., 1.5})
        EXPECT_NEAR(mdr_shakedown_traction(rho, 0, u), cattaneo_mindlin_traction(rho, f), 1e-14);
}

TEST(OscillatingRolling, RefusesArgumentsOutOfRange) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-.1, 1.1, nan}) {
        EXPECT_THROW(settled_shift_ratio(bad, .1), std::domain_error);
        EXPECT_THROW(settled_shift_ratio(.1, bad), std::domain_error);
        EXPECT_THROW(shakedown_limit(bad), std::domain_error);
        EXPECT_THROW(amplitude_limit(bad), std::domain_error);
        EXPECT_THROW(mdr_threshold_slope(bad), std::domain_error);
        EXPECT_THROW(mapping_parameter(.1, .1, bad), std::domain_error);
        EXPECT_THROW(thesis_increment_parallel(bad, .1), std::domain_error);
        EXPECT_THROW(thesis_increment_perpendicular(.1, bad), std::domain_error);
    }
    for (const double kappa : {0., 1.6, nan}) {
        EXPECT_THROW(shakedown_limit(.1, kappa), std::domain_error);
        EXPECT_THROW(settled_shift_ratio(.1, .1, kappa), std::domain_error);
        EXPECT_THROW(amplitude_limit(.1, kappa), std::domain_error);
    }
    EXPECT_THROW(mapping_parameter(0, .1, .5), std::domain_error);
    EXPECT_THROW(shakedown_zones(.5, .8), std::domain_error);
    EXPECT_THROW(mdr_shakedown_traction(-1, .1, .2), std::domain_error);
}

}  // namespace
}  // namespace tricontact::oscillating_rolling_test

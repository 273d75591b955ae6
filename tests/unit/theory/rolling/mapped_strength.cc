#include "theory/rolling/mapped_strength.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include "theory/rolling/rolled_law.h"

namespace tricontact::mapped_strength_test {
namespace {

using std::numbers::pi;
using theory::MappedRolling;

double n_of(const MappedRolling& p) {
    return p.poisson * std::cos(2 * p.angle) / (3 * (2 - p.poisson));
}

double integral(const std::function<double(double)>& f, double from, double to) {
    return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, from, to, 12, 1e-11);
}

// What the rim's load loses by the slip of its place, from the displacement beside a flat punch:
// tangential traction 1/sqrt(c^2 - s^2) and Cerruti's u_x of a point force, summed over the punch.
double rim_slip(double c, double theta, double nu) {
    // Over polar coordinates (s, alpha) in the punch, the rim's point at 1.
    const auto ring = [&](double t) {
        const double s = c * std::sin(t);  // the traction's root goes with ds
        const auto point = [&](double alpha) {
            const double x = std::cos(theta) - s * std::cos(alpha),
                         y = std::sin(theta) - s * std::sin(alpha);
            const double r = std::hypot(x, y);
            return (1 - nu) / r + nu * x * x / (r * r * r);
        };
        return s * integral(point, 0, 2 * pi);
    };
    // The punch itself moves by pi^2 (1 - nu/2).
    return 1 - integral(ring, 0, pi / 2) / (pi * pi * (1 - nu / 2));
}

TEST(MappedStrength, SmallAmplitudesAreWhatTheRimLoses) {
    for (const MappedRolling& p : {MappedRolling{0, 0, 0, 0}, MappedRolling{0, 0, 0, .5},
                                   MappedRolling{0, 0, pi / 2, .5}, MappedRolling{0, 0, .6, .3}})
        for (const double u : {.3, .6, .9}) {
            const double c = std::sqrt(1 - u * u);
            // The rim has W |cos(theta - angle)|, all of it pi tau_0 a^2.
            const double lost = integral(
                [&](double theta) {
                    return std::abs(std::cos(theta - p.angle)) * rim_slip(c, theta, p.poisson);
                },
                p.angle - pi / 2, p.angle + pi / 2);
            EXPECT_NEAR(theory::small_amplitude_strength_mapping(p, u), 2 * lost / (pi * u), 1e-8)
                << u;
        }
}

TEST(MappedStrength, SmallAmplitudesHaveTheirEnds) {
    for (const double nu : {0., .3, .5})
        for (const double angle : {0., .4, pi / 2}) {
            const MappedRolling rest{.angle = angle, .poisson = nu};
            const double small = 8 / (pi * pi) * (1 - n_of(rest));
            EXPECT_DOUBLE_EQ(theory::small_amplitude_strength_mapping(rest, 0), small);
            EXPECT_NEAR(theory::small_amplitude_strength_mapping(rest, 1e-6), small, 1e-9);
            EXPECT_DOUBLE_EQ(theory::small_amplitude_strength_mapping(rest, 1), 4 / pi);
            EXPECT_DOUBLE_EQ(theory::strength_mapping(rest), small);
            EXPECT_NEAR(theory::strength_mapping({1e-6, 0, angle, nu}), small, 1e-5);
        }
}

TEST(MappedStrength, LargestShiftIsThatOfTheLensCentre) {
    for (const double w : {.05, .3, .6, .85})
        EXPECT_NEAR(theory::largest_strength_shift_ratio({w, 0, .7, 0}),
                    2 / pi * (boost::math::ellint_2(w) - w), 1e-12);
    for (const double nu : {.3, .5})
        for (const double angle : {0., pi / 2}) {
            const MappedRolling p{1e-4, 0, angle, nu};
            EXPECT_NEAR((1 - theory::largest_strength_shift_ratio(p)) / 1e-4,
                        2 / pi * (1 + n_of(p)), 1e-4);
        }
}

// Both ends of the load at any amplitude: the punch, and the lens.
TEST(MappedStrength, EndsAtTheLimitWithItsExactShift) {
    const auto& law = theory::strength_rolling;
    for (const double nu : {0., .5})
        for (const double angle : {0., pi / 2})
            for (const double w : {.05, .3, .6, .85}) {
                const double limit = law.exact_limit(w);
                EXPECT_NEAR(limit, 2 / pi * (std::acos(w) - w * std::sqrt(1 - w * w)), 1e-15);
                const MappedRolling p{w, limit, angle, nu};
                EXPECT_NEAR(*theory::strength_settled_shift_ratio(p),
                            theory::largest_strength_shift_ratio(p), 1e-9);
                EXPECT_FALSE(
                    theory::strength_settled_shift_ratio({w, limit * (1 + 1e-9), angle, nu}));
                EXPECT_LT(theory::strength_mapping(p), law.mdr_mapping);
            }
    EXPECT_NEAR(theory::strength_mapping({.4, 0, .2, 0}),
                theory::small_load_mapping(.4) * (4 / pi) / 1.5, 1e-12);
}

// (8/pi^2) arcsin(u)/u to 3 % of kappa: the formula has no other data there.
TEST(MappedStrength, FollowsSmallAmplitudes) {
    for (const double f : {.1, .4, .7, .9}) {
        const double w = 1e-3, u = *theory::strength_settled_shift_ratio({w, f, 0, 0});
        EXPECT_NEAR(theory::strength_mapping({w, f, 0, 0}) /
                        theory::small_amplitude_strength_mapping({}, u),
                    1, .03)
            << f;
    }
}

TEST(MappedStrength, RejectsWhatLiesOutside) {
    for (const MappedRolling& p :
         {MappedRolling{.86, .1}, MappedRolling{.1, 1.1}, MappedRolling{.1, .1, 0, .6}}) {
        EXPECT_THROW(theory::strength_mapping(p), std::domain_error);
        EXPECT_THROW(theory::largest_strength_shift_ratio(p), std::domain_error);
        EXPECT_THROW(theory::small_amplitude_strength_mapping(p, .1), std::domain_error);
    }
    EXPECT_THROW(theory::small_amplitude_strength_mapping({}, 1.1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::mapped_strength_test

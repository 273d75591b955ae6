#include "theory/rolling/mapped_shakedown.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::mapped_shakedown_test {
namespace {

using std::numbers::pi;
using theory::MappedRolling;

double small_value(const MappedRolling& p) {
    return 3 / pi * (1 - p.poisson * std::cos(2 * p.angle) / (3 * (2 - p.poisson)));
}

TEST(MappedShakedown, HasTheLimitsOfSmallAmplitudes) {
    for (const double nu : {0., .3, .5})
        for (const double angle : {0., .4, pi / 2}) {
            const MappedRolling rest{.angle = angle, .poisson = nu};
            EXPECT_DOUBLE_EQ(theory::half_space_mapping(rest), small_value(rest));
            EXPECT_DOUBLE_EQ(theory::simple_half_space_mapping(rest), small_value(rest));
            EXPECT_DOUBLE_EQ(theory::small_amplitude_mapping(rest), small_value(rest));
            for (const double f : {.1, .5, .95})
                EXPECT_NEAR(*theory::half_space_settled_shift_ratio({0, f, angle, nu}),
                            theory::static_shift_ratio(f), 1e-14)
                    << f;
        }
}

TEST(MappedShakedown, HasTheExactLimitOfShakedown) {
    for (const double w : {.1, .5, .85}) {
        const double limit = theory::shakedown_limit(w);
        EXPECT_TRUE(theory::half_space_settled_shift_ratio({w, limit, .3, .5}));
        EXPECT_FALSE(theory::half_space_settled_shift_ratio({w, limit + 1e-9, .3, .5}));
    }
}

TEST(MappedShakedown, DependsOnNoAngleWithoutPoissonsRatio) {
    const auto kappa = [](double angle, double nu) {
        return theory::half_space_mapping({.4, .2, angle, nu});
    };
    EXPECT_DOUBLE_EQ(kappa(0, 0), kappa(1.2, 0));
    EXPECT_LT(kappa(0, .3), kappa(0, 0));       // rolling along the load settles earlier
    EXPECT_GT(kappa(pi / 2, .3), kappa(0, 0));  // than across
    EXPECT_NEAR(kappa(.2, .3), kappa(pi - .2, .3), 1e-14);
}

TEST(MappedShakedown, FollowsTheExactSmallAmplitudes) {
    for (const double nu : {0., .5})
        for (const double angle : {0., pi / 2}) {
            for (const double f : {.02, .1, .3, .5, .7, .9}) {
                const MappedRolling p{0, f, angle, nu};
                EXPECT_NEAR(theory::half_space_mapping(p) / theory::small_amplitude_mapping(p), 1,
                            .02)
                    << f;
            }
            // Towards f = 1 all depends on (1 - f)^(1/3).
            const MappedRolling full{0, 1, angle, nu}, near{0, 1 - 1e-12, angle, nu};
            EXPECT_EQ(theory::small_amplitude_mapping(full), 1.5);
            EXPECT_NEAR(theory::small_amplitude_mapping(near), 1.5, 2e-4);
            const MappedRolling small{0, 1e-6, angle, nu};
            EXPECT_NEAR(theory::small_amplitude_mapping(small), small_value(small), 1e-6);
        }
}

TEST(MappedShakedown, FollowsThePunchOfTheCommonContact) {
    EXPECT_NEAR(theory::small_load_mapping(1e-5), 3 / pi, 1e-5);
    for (const double w : {.05, .2, .4, .6, .8, .85})
        EXPECT_NEAR(theory::half_space_mapping({w, 0, 0, 0}) / theory::small_load_mapping(w), 1,
                    .005)
            << w;
}

TEST(MappedShakedown, LargestShift) {
    for (const double nu : {0., .3, .5})
        for (const double angle : {0., pi / 2}) {
            const double n = nu * std::cos(2 * angle) / (3 * (2 - nu));
            EXPECT_NEAR(theory::largest_settled_shift_ratio({0, 0, angle, nu}), 1, 1e-12);
            const double w = 1e-4;
            EXPECT_NEAR((1 - theory::largest_settled_shift_ratio({w, 0, angle, nu})) / w,
                        8 / (pi * pi) * (1 + n), 1e-4);
            for (const double wide : {.05, .3, .6, .85}) {
                const MappedRolling p{wide, theory::shakedown_limit(wide), angle, nu};
                EXPECT_NEAR(*theory::half_space_settled_shift_ratio(p) /
                                theory::largest_settled_shift_ratio(p),
                            1, .034)
                    << wide;
            }
        }
}

TEST(MappedShakedown, RejectsWhatLiesOutside) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const MappedRolling& p :
         {MappedRolling{.86, .1}, MappedRolling{-.1, .1}, MappedRolling{.1, 1.1},
          MappedRolling{.1, .1, nan}, MappedRolling{.1, .1, 0, .6}, MappedRolling{nan, .1}}) {
        EXPECT_THROW(theory::half_space_mapping(p), std::domain_error);
        EXPECT_THROW(theory::simple_half_space_mapping(p), std::domain_error);
        EXPECT_THROW(theory::half_space_settled_shift_ratio(p), std::domain_error);
        EXPECT_THROW(theory::small_amplitude_mapping(p), std::domain_error);
        EXPECT_THROW(theory::largest_settled_shift_ratio(p), std::domain_error);
    }
    EXPECT_THROW(theory::small_load_mapping(0), std::domain_error);
    EXPECT_THROW(theory::small_load_mapping(1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::mapped_shakedown_test

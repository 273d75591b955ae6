#include "theory/rolling/mapped_ratcheting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::mapped_ratcheting_test {
namespace {

using std::numbers::pi;

TEST(MappedRatcheting, BeginsAtTheExactLimit) {
    for (const double w : {.1, .4, .85}) {
        const double limit = theory::shakedown_limit(w);
        EXPECT_EQ(theory::half_space_shift_increment_ratio({w, limit * (1 - 1e-9), .3, .5}), 0);
        EXPECT_THROW(theory::half_space_ratcheting_slope({w, limit * (1 - 1e-9), .3, .5}),
                     std::domain_error);
        // In proportion to the excess of the amplitude.
        const double slope = theory::half_space_ratcheting_slope({w, limit + 1e-7, .3, .5});
        const double excess = w - theory::amplitude_limit(limit + 1e-7);
        EXPECT_NEAR(theory::half_space_shift_increment_ratio({w, limit + 1e-7, .3, .5}),
                    slope * excess, 1e-12);
        EXPECT_GT(slope, 0);
    }
}

TEST(MappedRatcheting, DependsOnNoAngleWithoutPoissonsRatio) {
    const auto slope = [](double angle, double nu) {
        return theory::half_space_ratcheting_slope({.4, .6, angle, nu});
    };
    EXPECT_DOUBLE_EQ(slope(0, 0), slope(1.2, 0));
    EXPECT_LT(slope(0, .3), slope(0, 0));
    EXPECT_GT(slope(pi / 2, .3), slope(0, 0));
    EXPECT_NEAR(slope(.2, .3), slope(pi - .2, .3), 1e-14);
}

TEST(MappedRatcheting, IsOfTheOrderOfFourNearSliding) {
    // w_lim and the stick radius vanish: 4/0.98 for nu = 0.
    EXPECT_NEAR(theory::half_space_ratcheting_slope({.5, 1, 0, 0}), 4 / .98, 1e-12);
}

TEST(MappedRatcheting, RefusesWhatIsOutOfRange) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const theory::MappedRolling& bad : {theory::MappedRolling{-.1, .5, 0, .3},
                                             {.86, .5, 0, .3},
                                             {.5, 1.1, 0, .3},
                                             {.5, -.1, 0, .3},
                                             {.5, .9, nan, .3},
                                             {.5, .9, 0, .6},
                                             {nan, .9, 0, .3}})
        EXPECT_THROW(theory::half_space_shift_increment_ratio(bad), std::domain_error);
}

}  // namespace
}  // namespace tricontact::mapped_ratcheting_test

#include "theory/rolling/oscillating_rolling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/run.h"
#include "tests/verification/mdr/roller.h"

namespace tricontact::mdr_oscillating_rolling_test {
namespace {

using mdr_test::Roller;
using mdr_test::sphere_rig;

// A kink of the line load inside a cell costs the midpoint rule up to dx^2/12 of its jump in slope;
// kappa divides that by w u. From 10000 springs on this stays below 1e-6 for w u > 0.04.
constexpr int many_springs = 10000;

TEST(MdrOscillatingRolling, MappingParameterIsThreeHalves) {
    const double points[][2] = {{.1, .3},   {.24, .24}, {.24, .56},
                                {.51, .09}, {.51, .24}, {.8, .04}};
    for (const auto& [w, f] : points) {
        Roller roller(sphere_rig(w, f, many_springs, 1));
        roller.roll(80);
        ASSERT_LT(std::abs(roller.increment_ratio()), 1e-9) << w << ' ' << f;  // it has settled
        EXPECT_NEAR(roller.mapping(), 1.5, 1e-6) << w << ' ' << f;
        EXPECT_TRUE(roller.model().audit().passed());
    }
}

TEST(MdrOscillatingRolling, SettledShiftConvergesWithTheBed) {
    const double w = .24, f = .56, exact = *theory::settled_shift_ratio(w, f);
    // The error depends on where the kinks fall in their cells: mean square of neighbouring beds.
    auto error = [&](int springs) {
        double squares = 0;
        constexpr int n_beds = 60;
        for (int k = 0; k < n_beds; ++k) {
            Roller roller(sphere_rig(w, f, springs + k, 1));
            const double difference = roller.roll(40).shift_ratio() - exact;
            squares += difference * difference / n_beds;
        }
        return std::sqrt(squares);
    };
    const double coarse = error(251), medium = error(500), fine = error(1001);
    EXPECT_NEAR(std::log2(coarse / medium), 2, 0.4);  // a mean of samples, not exact
    EXPECT_NEAR(std::log2(medium / fine), 2, 0.4);
    EXPECT_LT(fine, 2e-6);  // 8 kinks of dx^2/27 in the mean at dx = 2.5e-3 a, in random sum
}

TEST(MdrOscillatingRolling, TurningPointsSufficeForShakedown) {
    for (const auto& [w, f] : {std::pair{.24, .56}, std::pair{.51, .24}}) {
        const double turning = Roller(sphere_rig(w, f, 4000, 1)).roll(60).shift_ratio();
        for (const int steps : {2, 7, 60}) {
            const double fine = Roller(sphere_rig(w, f, 4000, steps)).roll(60).shift_ratio();
            // d varies by dx^2 = 4e-7 with the position of the contact between the springs
            EXPECT_NEAR(fine, turning, 1e-6) << w << ' ' << f << ' ' << steps;
        }
    }
}

TEST(MdrOscillatingRolling, DissipationVanishesAtShakedown) {
    Roller roller(sphere_rig(.24, .56, 1000, 6));
    roller.roll(1);
    const double first = roller.dissipation_ratio();
    roller.roll(40);
    EXPECT_GT(first, 1e-3);
    EXPECT_LT(roller.dissipation_ratio(), 1e-12 * first);  // rounding
}

TEST(MdrOscillatingRolling, RatchetingIncrements) {
    const double points[][3] = {
        {.24, .80, .4031}, {.51, .72, 1.0889}, {.74, .72, 1.6748}, {.51, .90, 1.9403}};
    for (const auto& [w, f, increment] : points) {
        Roller roller(sphere_rig(w, f, 1000, 60));
        // references of another program, printed to four decimals, its bed's error of the same
        // order
        EXPECT_NEAR(roller.roll(12).increment_ratio(), increment, 1.5e-4) << w << ' ' << f;
    }
}

// Du/(w - w_lim) at the limit, first order both in the distance to it and in the step: one
// Richardson extrapolation in each.
TEST(MdrOscillatingRolling, ThresholdSlope) {
    for (const double f : {.3, .72, .9}) {
        const double limit = theory::amplitude_limit(f);
        auto slope = [&](double excess, int steps) {
            Roller roller(sphere_rig(limit + excess, f, 2000, steps));
            return roller.roll(60).increment_ratio() / excess;
        };
        auto at_limit = [&](int steps) { return 2 * slope(2.5e-3, steps) - slope(5e-3, steps); };
        const double extrapolated = 2 * at_limit(48) - at_limit(24);
        // the two limits do not quite commute: steps of 1/48 quarter against an excess of 1/400
        EXPECT_NEAR(extrapolated / theory::mdr_threshold_slope(f), 1, 2e-3) << f;
    }
}

TEST(MdrOscillatingRolling, LimitFromTheOverlapOfPressures) {
    for (const double w : {.1, .24, .51, .9}) {
        Roller roller(sphere_rig(w, .01, 1000, 1));
        roller.roll(1);
        // midpoint rule at the kinks: dx^2/4 for dx = 2 (1 + w)/1000
        EXPECT_NEAR(roller.model().limit_tangential_ratio(), theory::shakedown_limit(w), 4e-6) << w;
    }
}

TEST(MdrOscillatingRolling, LimitFromBisection) {
    for (const double w : {.24, .51}) {
        // Settling, the increments decay geometrically; at the limit itself like 1/n^2, that is by
        // 0.56 from period 150 to 200; ratcheting, they stay.
        auto ratchets = [w](double f) {
            Roller roller(sphere_rig(w, f, 1000, 1));
            const double earlier = roller.roll(150).increment_ratio();
            return roller.roll(50).increment_ratio() > .8 * earlier && earlier > 1e-9;
        };
        double settles = 0, limit = 1 - 1e-9;
        while (limit - settles > 1e-5) {
            const double middle = (settles + limit) / 2;
            (ratchets(middle) ? limit : settles) = middle;
        }
        EXPECT_NEAR(limit, theory::shakedown_limit(w), 1e-4) << w;  // what 200 periods resolve
    }
}

TEST(MdrOscillatingRolling, RunsAtTheLimitAndAtTheExtremes) {
    for (const double w : {.05, .24, .51, .9})
        for (const double part : {.999, 1.001}) {
            Roller roller(sphere_rig(w, part * theory::shakedown_limit(w), 1000, 6));
            roller.roll(30);
            for (const auto& check : roller.model().audit().checks())
                EXPECT_TRUE(check.passed()) << check.name << ' ' << check.worst << ' ' << w;
        }
    Roller extreme(sphere_rig(1, .999, 1000, 6));
    extreme.roll(12);
    EXPECT_TRUE(extreme.model().audit().passed());
    EXPECT_GT(extreme.increment_ratio(), 1);
}

TEST(MdrOscillatingRolling, AngleMakesNoDifference) {
    const double parallel = Roller(sphere_rig(.24, .56, 500, 6)).roll(8).shift_ratio();
    for (const double angle : {.3, std::acos(0.), 2.5}) {
        contact::Case c = sphere_rig(.24, .56, 500, 6);
        c.rolling->angle = angle;
        // path lengths differ by the rounding of cos^2 + sin^2
        EXPECT_NEAR(Roller(c).roll(8).shift_ratio(), parallel, 1e-12) << angle;
    }
}

// Uncoupled contact shakes down as long as its points can carry F_T at their least bounds
// (Klarbring, Ciavarella and Barber 2007), also where F_N oscillates and is not its mean when
// rolling begins.
TEST(MdrOscillatingRolling, LimitUnderOscillatingNormalForceIsThatOfTheLeastPressure) {
    for (const double phase : {0., std::numbers::pi / 4, std::numbers::pi / 2}) {
        auto rolled = [&](double f) {
            contact::Case c = sphere_rig(.24, f, 2000, 8);
            c.load.normal_amplitude_ratio = .4;
            c.load.normal_phase = phase;
            c.rolling->periods = 300;
            return contact::run(c, *mdr::make_model(c));
        };
        const double limit = rolled(.1).limit_tangential_ratio;
        EXPECT_EQ(rolled(.995 * limit).verdict.state, contact::State::shakedown) << phase;
        EXPECT_EQ(rolled(1.005 * limit).verdict.state, contact::State::ratcheting) << phase;
    }
}

}  // namespace
}  // namespace tricontact::mdr_oscillating_rolling_test

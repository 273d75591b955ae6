// Oscillating rolling on the half-space against the numbers of two other boundary element programs
// (which agree with each other to 5 digits; 0.2 mm cells, nu = 1/2) and against the exact limit.

#include "theory/rolling/oscillating_rolling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "comparisons/run/peer_shifts.h"
#include "contact/cells.h"
#include "tests/verification/bem/rig.h"

namespace tricontact::bem::bem_oscillating_rolling_test {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

/// "w24_f56" for a test's name.
std::string name_of(double w, double f) {
    std::string name = "w";
    name += std::to_string(std::lround(100 * w));
    name += "_f";
    name += std::to_string(std::lround(100 * f));
    return name;
}

class BemTable : public ::testing::TestWithParam<comparisons::PeerShifts> {};

// 0.2 %: the programs place their grids differently under the contact.
TEST_P(BemTable, ParallelAndPerpendicularShakedown) {
    const comparisons::PeerShifts row = GetParam();
    contact::Case c = rig_case(row.w, row.f, 60);
    const contact::History parallel = run_bem(c);
    EXPECT_NEAR(static_ratio(parallel) / row.static_ratio, 1, 2e-3);
    EXPECT_NEAR(final_ratio(parallel) / row.parallel, 1, 2e-3);
    EXPECT_EQ(parallel.verdict.state, contact::State::shakedown);

    c.rolling->angle = right_angle;
    const contact::History perpendicular = run_bem(c);
    EXPECT_NEAR(final_ratio(perpendicular) / row.perpendicular, 1, 2e-3);
    EXPECT_EQ(perpendicular.verdict.state, contact::State::shakedown);
}

INSTANTIATE_TEST_SUITE_P(HalfSpace, BemTable,
                         ::testing::ValuesIn(comparisons::half_space_peer_shifts),
                         [](const auto& row) { return name_of(row.param.w, row.param.f); });

// f_lim(0.51) = 1 - 1.5 w + 0.5 w^3 = 0.30133: half a per cent below settles, one above does not.
TEST(BemLimit, SettlesBelowAndRatchetsAbove) {
    EXPECT_EQ(run_bem(rig_case(.51, .30, 60)).verdict.state, contact::State::shakedown);
    EXPECT_EQ(run_bem(rig_case(.51, .304, 60)).verdict.state, contact::State::ratcheting);
}

TEST(BemLimit, OverlapOfPressuresIsTheClosedForm) {
    for (const double w : {0.1, 0.24, 0.51, 0.9}) {
        const contact::History h = run_bem(rig_case(w, 0.01, 1));
        // The edge of the overlap is cut by square cells: O(h); 1e-3 at 22 cells per radius.
        EXPECT_NEAR(h.limit_tangential_ratio, theory::shakedown_limit(w), 1e-3) << w;
    }
}

// At and beyond the limit every step converges, forces to 1e-9 relative.
TEST(BemLimit, EveryStepConvergesAtTheLimit) {
    struct Point {
        double w, f;
    };
    const double limit = theory::shakedown_limit(.51);
    for (const Point point : {Point{.51, .999 * limit}, Point{.51, 1.001 * limit}, Point{1, .999},
                              Point{.24, .999}, Point{1, .05}}) {
        for (const double angle : {0.0, right_angle}) {
            contact::Case c = rig_case(point.w, point.f, 4);
            c.rolling->angle = angle;
            c.rolling->steps = contact::Case::Steps::per_quarter;
            c.rolling->steps_per_quarter = 3;
            const contact::History h = run_bem(c);
            for (const auto& step : h.steps)
                ASSERT_LE(step.force_residual, 1e-9) << point.w << ' ' << point.f;
            EXPECT_TRUE(h.audit.passed());
        }
    }
}

TEST(BemSteps, TurningPointsSettleWhereFineStepsDo) {
    contact::Case c = rig_case(.24, .56, 40);
    const double coarse = final_ratio(run_bem(c));
    c.rolling->steps = contact::Case::Steps::per_quarter;
    c.rolling->steps_per_quarter = 6;
    // Uncoupled shakedown depends on the turning points only; the rest is solver tolerance.
    EXPECT_NEAR(final_ratio(run_bem(c)), coarse, 1e-4);
}

// Below the limit everything sticks in the end: points slip less from period to period, then not at
// all. Above it the indenter moves on over all points, and slips back and forth on the way.
TEST(BemSlipPath, GoesToZeroInShakedownAndBeyondTheIncrementInRatcheting) {
    contact::Case c = rig_case(.24, .56, 40);
    c.of<contact::Cells>().spacing = 5e-4;
    const contact::History settled = run_bem(c);
    const auto& path = settled.slip_path_per_period;
    ASSERT_EQ(path.size(), settled.shift_per_period.size());
    EXPECT_TRUE(std::is_sorted(path.rbegin(), path.rend()));
    EXPECT_GT(path.front(), .05 * settled.scales.unit_shift);
    EXPECT_EQ(path.back(), 0);
    EXPECT_EQ(settled.friction_work_per_period.back(), 0);
    c = rig_case(.24, .8, 6);
    c.of<contact::Cells>().spacing = 5e-4;
    const contact::History ratchets = run_bem(c);
    EXPECT_GT(ratchets.slip_path_per_period.back(),
              increment_ratio(ratchets) * ratchets.scales.unit_shift);
}

TEST(BemSteps, ObliqueRollingLiesBetween) {
    contact::Case c = rig_case(.24, .56, 30);
    const double parallel = final_ratio(run_bem(c));
    c.rolling->angle = std::numbers::pi / 4;
    const double oblique = final_ratio(run_bem(c));
    c.rolling->angle = right_angle;
    const double perpendicular = final_ratio(run_bem(c));
    EXPECT_LT(parallel + 2e-3, oblique);  // the gap of 0.023 is split, not touched
    EXPECT_LT(oblique + 2e-3, perpendicular);
}

/// Du per period, W divided into n steps per quarter.
double ratcheting_increment(double w, double f, double angle, int n) {
    contact::Case c = rig_case(w, f, 8);
    c.rolling->angle = angle;
    c.rolling->steps = contact::Case::Steps::per_quarter;
    c.rolling->steps_per_quarter = n;
    return increment_ratio(run_bem(c));
}

struct Ratcheting {
    double w, f, angle;
    double coarse;        // at dW = 0.2 mm
    double extrapolated;  // 0: not published
};

class BemRatcheting : public ::testing::TestWithParam<Ratcheting> {};

TEST_P(BemRatcheting, IncrementsAndTheirExtrapolation) {
    const Ratcheting row = GetParam();
    const double cells = row.w * 4.50289e-3 / 2e-4;  // W over 0.2 mm: 5.4 and 11.5
    const int n = static_cast<int>(std::ceil(cells));
    const double once = ratcheting_increment(row.w, row.f, row.angle, n);
    const double twice = ratcheting_increment(row.w, row.f, row.angle, 2 * n);
    const double limit = 2 * twice - once;  // first order in the step
    // The table's steps are 0.2 mm, ours a little shorter: correct to first order.
    const double at_table_step = limit + (once - limit) * n / cells;
    EXPECT_NEAR(at_table_step / row.coarse, 1, 1e-2);
    if (row.extrapolated > 0) {
        EXPECT_NEAR(limit / row.extrapolated, 1, 1e-2);
    }
}

INSTANTIATE_TEST_SUITE_P(HalfSpace, BemRatcheting,
                         ::testing::Values(Ratcheting{.24, .80, 0, .1577, .159},
                                           Ratcheting{.51, .72, 0, .4607, .465},
                                           Ratcheting{.24, .80, right_angle, .2237, 0},
                                           Ratcheting{.51, .72, right_angle, .6434, 0}),
                         [](const auto& row) {
                             return name_of(row.param.w, row.param.f) +
                                    (row.param.angle == 0 ? "_parallel" : "_perpendicular");
                         });

// Halving the step halves the error: the order is asserted, not assumed. Steps of 4, 2, 1 and 1/2
// cells, so that the grid looks the same from every position.
TEST(BemSteps, RatchetingIsFirstOrderInTheStep) {
    auto increment = [](int n) {
        contact::Case c = rig_case(.5, .72, 5);
        c.rolling->amplitude_ratio.reset();
        c.rolling->amplitude = 12 * 2e-4;
        c.rolling->steps = contact::Case::Steps::per_quarter;
        c.rolling->steps_per_quarter = n;
        return increment_ratio(run_bem(c));
    };
    const double limit = 2 * increment(24) - increment(12);
    const double order = std::log2((limit - increment(3)) / (limit - increment(6)));
    // Cells enter and leave the contact one by one; consecutive differences scatter by 30 %.
    EXPECT_NEAR(order, 1, 0.2);
}

}  // namespace
}  // namespace tricontact::bem::bem_oscillating_rolling_test

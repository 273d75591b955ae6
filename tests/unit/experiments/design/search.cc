// The search of a design and the comparison that it plans: against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/special_values.h"
#include "experiments/design/design_search.h"
#include "experiments/design/level_line.h"
#include "experiments/design/planned_comparison.h"

namespace tricontact::experiments::design_search_test {
namespace {

// One requirement falls, the other rises: the worst is least where both are equal.
TEST(DesignSearch, OneKeyEndsWhereTwoPowersMeet) {
    const auto ratios = [](const std::vector<double>& t) {
        const double b = 1 + 9 * t[0];
        return std::vector<double>{4 / (b * b), b / 5};
    };
    const DesignSolution s = search_design(ratios, 1);
    const double meets = std::cbrt(20.);  // 4/b^2 = b/5
    // The simplex ends at 3e-4 of the range of 9.
    EXPECT_NEAR(1 + 9 * s.best.fractions[0], meets, 1e-2);
    EXPECT_EQ(s.best.binding().size(), 2U);
    EXPECT_TRUE(s.best.is_feasible());
    ASSERT_EQ(s.stretches.size(), 1U);
    // Seven bisections of an eighth of what lies towards the bound.
    EXPECT_NEAR(1 + 9 * s.stretches[0].low, 2, 1e-2);
    EXPECT_NEAR(1 + 9 * s.stretches[0].high, 5, 1e-2);
    EXPECT_EQ(s.stretches[0].low_requirement, 0U);
    EXPECT_EQ(s.stretches[0].high_requirement, 1U);
    EXPECT_TRUE(s.widenings.empty());
}

// A crease oblique to both axes: on it 0.2 + x - y = 0.2 - x + y, and it falls along x + y to the
// circle's third requirement.
TEST(DesignSearch, TwoKeysFollowACrease) {
    const auto ratios = [](const std::vector<double>& t) {
        const double along = 1 - (t[0] + t[1]) / 2, across = 3 * (t[0] - t[1]);
        return std::vector<double>{along + across, along - across,
                                   (t[0] * t[0] + t[1] * t[1]) / 0.98};
    };
    const DesignSolution s = search_design(ratios, 2);
    // x = y, 1 - x = 2 x^2/0.98: both roots of a quadratic.
    const double c = 2 / 0.98, x = (-1 + std::sqrt(1 + 4 * c)) / (2 * c);
    EXPECT_NEAR(s.best.fractions[0], x, 1e-2);
    EXPECT_NEAR(s.best.fractions[1], x, 1e-2);
    EXPECT_NEAR(s.best.worst(), 1 - x, 5e-3);
    EXPECT_EQ(s.map.size(), s.grid.size());
}

TEST(DesignSearch, NothingFeasibleNamesTheBoundInTheWay) {
    const auto ratios = [](const std::vector<double>& t) {
        return std::vector<double>{3 - t[0], 0.5 + 0 * t[1]};
    };
    const DesignSolution s = search_design(ratios, 2);
    EXPECT_FALSE(s.best.is_feasible());
    EXPECT_NEAR(s.best.worst(), 2, 1e-6);
    ASSERT_EQ(s.widenings.size(), 1U);
    EXPECT_EQ(s.widenings[0].axis, 0U);
    EXPECT_TRUE(s.widenings[0].upwards);
    EXPECT_TRUE(s.stretches.empty());
}

// Two requirements against each other, the best inside: no bound helps.
TEST(DesignSearch, NothingFeasibleInsideBlamesNoBound) {
    const DesignSolution s = search_design(
        [](const std::vector<double>& t) {
            return std::vector<double>{1.5 + t[0], 2.5 - t[0]};
        },
        1);
    EXPECT_NEAR(s.best.worst(), 2, 1e-3);
    EXPECT_TRUE(s.widenings.empty());
}

TEST(DesignSearch, WhatIsNotKnownIsNotProposed) {
    const DesignSolution s = search_design(
        [](const std::vector<double>& t) {
            return std::vector<double>{t[0] < 0.5 ? contact::undefined : t[0]};
        },
        1);
    EXPECT_NEAR(s.best.fractions[0], 0.5, 1e-9);
    EXPECT_FALSE(s.stretches[0].low_requirement);
    EXPECT_GE(s.stretches[0].low, 0.5);
    const DesignSolution none = search_design(
        [](const std::vector<double>&) { return std::vector<double>{contact::undefined}; }, 1);
    EXPECT_TRUE(std::isinf(none.best.worst()));
}

TEST(DesignSearch, FrontHoldsWhatNobodyBeats) {
    const auto front = pareto_front({{3, 1}, {1, 3}, {2, 2}, {2.5, 2.5}, {2, 4}, {4, 1}});
    EXPECT_EQ(front, (std::vector<std::pair<double, double>>{{1, 3}, {2, 2}, {3, 1}}));
}

// x + y = 1 on a linear function: exact.
TEST(LevelLine, IsExactOfLinearFunctions) {
    LevelGrid grid{{0, 0.3, 1}, {}};
    for (const double y : grid.places)
        for (const double x : grid.places) grid.values.push_back(x + y - 1);
    const auto pieces = zero_line(grid);
    ASSERT_FALSE(pieces.empty());
    for (const auto& [a, b] : pieces)
        for (const auto& p : {a, b}) EXPECT_NEAR(p.first + p.second, 1, 1e-15);
    grid.values[4] = contact::undefined;  // the middle, which all cells share
    EXPECT_TRUE(zero_line(grid).empty());
}

// A power law: each relative error counts with its exponent (JCGM 100:2008, 5.1.6).
TEST(PlannedComparison, SeesWhatAPowerLawAllows) {
    contact::Case c;
    c.friction.coefficient = 0.5;
    c.substrate = {2e6, 0.5};
    const std::vector<CaseQuantity> quantities{
        {.name = "friction.coefficient",
         .standard_error = 0.005,
         .of_case = [](contact::Case& any) -> double& { return *any.friction.coefficient; }},
        {.name = "substrate.young",
         .standard_error = 4e4,
         .of_case = [](contact::Case& any) -> double& { return any.substrate.young; }}};
    const auto shift = [](const contact::Case& any) {
        return any.friction_coefficient() * std::pow(any.substrate.young, -2. / 3);
    };
    const double u = shift(c);
    const ComparisonError e = planned_comparison(u, input_errors(shift, c, quantities),
                                                 {.scatter = 0.02 * u, .step = {}, .repeats = 1});
    const double relative = std::hypot(0.01, 2. / 3 * 0.02, 0.02);
    // Differences over an error of 2 % see the third derivative, 2e-4 of the first.
    EXPECT_NEAR(e.standard_error() / u, relative, 2e-4 * relative);
    EXPECT_NEAR(e.resolution(), (1.95996 + 1.64485) * relative, 2e-3 * relative);
    EXPECT_TRUE(e.agrees());
    // Correlated by 1/2, mu and E, whose exponents have other signs, take something off.
    const ComparisonError both = planned_comparison(
        u, input_errors(shift, c, quantities, {{1, .5}, {.5, 1}}), {.repeats = 1});
    const double correlated = 1e-4 + std::pow(2. / 3 * 0.02, 2) - 0.01 * 2. / 3 * 0.02;
    EXPECT_NEAR(std::pow(both.standard_error() / u, 2), correlated, 1e-3 * correlated);
}

// Four runs: half the scatter, Student's t of three values: 3.182 of 95 %.
TEST(PlannedComparison, TakesTheScatterOfRepeatsFromTheRuns) {
    const ComparisonError e = planned_comparison(1, {}, {.scatter = 0.1, .step = {}, .repeats = 4});
    EXPECT_NEAR(e.standard_error(), 0.05, 1e-15);
    EXPECT_NEAR(e.half_width(), 3.18245 * 0.05, 1e-5);
    const ComparisonError step =
        planned_comparison(1, {}, {.scatter = {}, .step = 0.12, .repeats = 1});
    EXPECT_NEAR(step.standard_error(), 0.12 / std::sqrt(12.), 1e-15);
}

}  // namespace
}  // namespace tricontact::experiments::design_search_test

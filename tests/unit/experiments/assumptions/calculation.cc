
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "contact/base/error.h"
#include "experiments/assumptions/assumption.h"
#include "experiments/assumptions/check_rig.h"

namespace tricontact::calculation_test {
using namespace experiments;
namespace {

// y = k x^3
Calculation cube() {
    return calculate("cube", "y", "k x^3", "", "m", {{"k", {2, 0.1}, "1"}, {"x", {3, 0.06}, "1"}},
                     [](const auto& v) { return v[0] * std::pow(v[1], 3); });
}

experiments::PrintedValue printed(double value, double error, double half_digit) {
    return {{{value, error}, {}, half_digit, half_digit}, "cube", "", ""};
}

PrintedCheck check(const experiments::PrintedValue& value) {
    const Assumption holder{.name = "",
                            .title = "",
                            .claim = "",
                            .criteria = {},
                            .background = {cube()},
                            .missing = {},
                            .consequence = ""};
    return check_printed({value}, {holder}).front();
}

TEST(RigCalculation, PropagatesTheErrorsOfWhatIsGiven) {
    EXPECT_DOUBLE_EQ(cube().result.value, 54);
    // Relative: 5 % of k and three times 2 % of x.
    EXPECT_NEAR(cube().result.standard_error, 54 * std::hypot(0.05, 0.06), 1e-9);
}

TEST(RigCalculation, FindsTheGivenNumberThatWouldLeadToAnother) {
    const auto found = substitutes(cube(), 2 * 54);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].needed, 4, 1e-9);
    EXPECT_NEAR(found[1].needed, 3 * std::cbrt(2), 1e-9);
    EXPECT_EQ(found[1].given, 3);
    EXPECT_TRUE(substitutes(cube(), -1).empty());
}

TEST(RigCalculation, APrintAgreesWhenItRoundsToTheSame) {
    using enum PrintedCheck::Agreement;
    EXPECT_EQ(check(printed(54.4, 0, 0.5)).agreement, agrees);
    EXPECT_EQ(check(printed(50, 0, 0.5)).agreement, within_error);  // 4.2 is the propagated error
    EXPECT_EQ(check(printed(70, 0, 0.5)).agreement, differs);
    EXPECT_EQ(check(printed(70, 20, 0.5)).agreement, within_error);
    EXPECT_FALSE(check(printed(54, 8.4, 0.5)).error_agrees);
    EXPECT_NEAR(*check(printed(54, 8.4, 0.5)).error_ratio, 8.4 / cube().result.standard_error,
                1e-9);
    EXPECT_TRUE(check(printed(54, 4, 0.5)).error_agrees);
    experiments::PrintedValue other = printed(54, 0, 1);
    other.name = "square";
    EXPECT_EQ(check(other).agreement, not_computed);
}

TEST(RigAssumption, StandsAsItsWeakestCriterion) {
    using enum Standing;
    const auto criterion = [](double threshold) {
        return Criterion{cube(), Criterion::Relation::at_most, threshold, ""};
    };
    EXPECT_EQ(criterion(60).standing(), holds);
    EXPECT_EQ(criterion(55).standing(), not_testable);  // within the error of 4.2
    EXPECT_EQ(criterion(40).standing(), violated);
    Assumption a{.name = "",
                 .title = "",
                 .claim = "",
                 .criteria = {criterion(60)},
                 .background = {},
                 .missing = {},
                 .consequence = ""};
    EXPECT_EQ(a.standing(), holds);
    a.missing = {"density"};
    EXPECT_EQ(a.standing(), not_testable);
    a.criteria.push_back(criterion(40));
    EXPECT_EQ(a.standing(), violated);
    a.criteria.clear();
    EXPECT_EQ(a.standing(), not_testable);
}

// y = k x^3 with x = 3 +- 0.06: ln y is normal to 1e-3; P(y > c) by its mean and variance,
// ln 54 - (0.05^2 + 3 0.02^2)/2 and 0.05^2 + 9 0.02^2. 20000 points of a Latin hypercube scatter by
// 0.3 %.
TEST(Criterion, ChanceOfViolationIsThatOfALogNormalNumber) {
    Criterion criterion{.calculation = cube()};
    criterion.threshold = 58;
    const double mean = std::log(54) - (.0025 + 3 * .0004) / 2, variance = .0025 + 9 * .0004,
                 due = .5 * std::erfc((std::log(58) - mean) / std::sqrt(2 * variance));
    EXPECT_NEAR(probability_of_violation(criterion, 20'000), due, .01);
    criterion.relation = Criterion::Relation::at_least;
    EXPECT_NEAR(probability_of_violation(criterion, 20'000), 1 - due, .01);
    // Nothing is known where the formula has no value.
    criterion.calculation.function = [](const auto&) -> double { throw std::domain_error("none"); };
    EXPECT_TRUE(std::isnan(probability_of_violation(criterion, 10)));
}

}  // namespace
}  // namespace tricontact::calculation_test

#include "statistics/bounded_least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/error.h"
#include "statistics/joint_covariance.h"

namespace tricontact::statistics::bounded_least_squares_test {
namespace {

// Rosenbrock's valley as residuals: minimum 0 at (1, 1); with x <= 1/2 the least is at (1/2, 1/4).
std::vector<double> rosenbrock(const std::vector<double>& x) {
    return {10 * (x[1] - x[0] * x[0]), 1 - x[0]};
}

TEST(BoundedLeastSquares, RosenbrocksValley) {
    const auto free = fit_within(rosenbrock, {-1.2, 1}, {{-5, -5}, {5, 5}});
    EXPECT_NEAR(free.x[0], 1, 1e-8);
    EXPECT_NEAR(free.x[1], 1, 1e-8);
    const auto bound = fit_within(rosenbrock, {-1.2, 1}, {{-5, -5}, {.5, 5}});
    EXPECT_EQ(bound.x[0], .5);
    EXPECT_NEAR(bound.x[1], .25, 1e-8);
    const auto held = fit_within(rosenbrock, {.3, 1}, {{.3, -5}, {.3, 5}});
    EXPECT_NEAR(held.x[1], .09, 1e-8);
    EXPECT_NEAR(held.sum_of_squares, .49, 1e-12);
}

TEST(BoundedLeastSquares, StepsBackFromWhereThereAreNoResiduals) {
    const auto line = [](const std::vector<double>& x) -> std::vector<double> {
        if (x[0] > 1.5) throw contact::InputError("no such place");
        return {x[0] * x[0] * x[0] - 2.5};
    };
    EXPECT_NEAR(fit_within(line, {.3}, {{0}, {9}}).x[0], std::cbrt(2.5), 1e-8);
    EXPECT_THROW(fit_within(line, {2}, {{0}, {9}}), contact::NotConverged);
}

// A variable of which hardly anything depends asks for a step of 1e9: it does not shorten that of
// the other one, whose least squares are those of a mean.
TEST(BoundedLeastSquares, AVariableWithoutEffectKeepsNoOtherOneBack) {
    const auto residuals = [](const std::vector<double>& x) -> std::vector<double> {
        return {x[0] - 3, x[0] - 5, 1e-9 * (x[1] - 700)};
    };
    const auto fit = fit_within(residuals, {0, 0}, {{-20, -9}, {20, 9}});
    EXPECT_NEAR(fit.x[0], 4, 1e-8);
    EXPECT_NEAR(fit.sum_of_squares, 2, 1e-12);
}

// Two groups that share a mean: degrees of freedom by Welch and Satterthwaite's formula, variance
// with estimated weights by Meier's (1953, Biometrics 9, 59), both to the order of 1/n^2.
TEST(JointCovariance, OfAMeanFromTwoGroups) {
    constexpr int n_a = 300, n_b = 400;
    constexpr double w_a = 3. / 4, w_b = 1. / 4;
    std::vector<double> column(n_a, 2.);
    column.resize(n_a + n_b, 1.);
    const auto c = joint_covariance(
        {column}, {{.n_rows = n_a, .is_known = false}, {.n_rows = n_b, .is_known = false}});
    EXPECT_NEAR(c.covariance[0][0], 1. / 1600, 1e-12);
    EXPECT_NEAR(c.degrees_of_freedom[0], n_a - w_a, 1e-9);
    constexpr double spread_a = w_a * w_a / (n_a - 1), spread_b = w_b * w_b / (n_b - 1);
    EXPECT_NEAR(c.effective_degrees[0] * (spread_a + spread_b), 1, 1e-3);
    const double of_weights = 4 * (w_a * w_b / (n_a - 1) + w_b * w_a / (n_b - 1));
    EXPECT_NEAR((c.inflation(0) - 1) / of_weights, 1, 1e-3);
    EXPECT_EQ(c.standard_errors[0], std::sqrt(c.adjusted[0][0]));
    const auto known = joint_covariance({column}, {{.n_rows = n_a}, {.n_rows = n_b}});
    EXPECT_TRUE(std::isinf(known.effective_degrees[0]));
    EXPECT_EQ(known.inflation(0), 1);
}

// One table that tells its error: exact normal theory, n - m degrees of freedom and nothing more.
TEST(JointCovariance, OfOneGroupIsThatOfStudent) {
    const auto c =
        joint_covariance({{1, 2, 3, 4, 5}, {1, 4, 9, 16, 25}}, {{.n_rows = 5, .is_known = false}});
    for (int k = 0; k < 2; ++k) {
        EXPECT_NEAR(c.effective_degrees[k], 3, 1e-9);
        EXPECT_NEAR(c.inflation(k), 1, 1e-9);
    }
}

TEST(JointCovariance, AProductThatIsToldAlone) {
    const auto c = joint_covariance({{1, 2, 3}, {.5, 1, 1.5}, {1, -2, 1}}, {{.n_rows = 3}});
    EXPECT_TRUE(std::isinf(c.standard_errors[0]));
    EXPECT_TRUE(std::isinf(c.standard_errors[1]));
    EXPECT_TRUE(std::isfinite(c.standard_errors[2]));
    const auto told = principal_directions(c, {0, 1});
    EXPECT_NEAR(told[0].components[1] / told[0].components[0], .5, 1e-12);
    EXPECT_TRUE(std::isinf(told[1].standard_error));
}

// Steps are of 1 at most: damping, divided by 8 at each of 600, would be 0 by then, and never grow
// where the kink asks for shorter ones.
TEST(BoundedLeastSquares, ShortensStepsAfterAnyNumberOfLongOnes) {
    const auto fit = fit_within(
        [](const std::vector<double>& x) {
            return std::vector<double>{std::abs(x[0] - 600.5) + 1};
        },
        {0.}, {{0.}, {2000.}});
    EXPECT_NEAR(fit.x[0], 600.5, 1e-3);
}

}  // namespace
}  // namespace tricontact::statistics::bounded_least_squares_test

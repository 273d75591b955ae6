#include "statistics/bounded_least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/error.h"
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

// Two groups of equal parameters: the variance is that of the weighted mean, and Welch and
// Satterthwaite's degrees of freedom those of their formula.
TEST(JointCovariance, OfAMeanFromTwoGroups) {
    const std::vector<std::vector<double>> columns{{2, 2, 2, 1, 1, 1, 1}};
    const auto c = joint_covariance(columns, {{3, false}, {4, false}});
    EXPECT_NEAR(c.covariance[0][0], 1. / 16, 1e-12);
    const double left_a = 3 - 12. / 16, left_b = 4 - 4. / 16;
    EXPECT_NEAR(c.degrees_of_freedom[0], left_a, 1e-12);
    EXPECT_NEAR(c.effective_degrees[0],
                1 / (std::pow(12. / 16, 2) / left_a + std::pow(4. / 16, 2) / left_b), 1e-9);
    EXPECT_TRUE(std::isinf(joint_covariance(columns, {{3, true}, {4, true}}).effective_degrees[0]));
}

TEST(JointCovariance, AProductThatIsToldAlone) {
    const auto c = joint_covariance({{1, 2, 3}, {.5, 1, 1.5}, {1, -2, 1}}, {{3, true}});
    EXPECT_TRUE(std::isinf(c.standard_errors[0]));
    EXPECT_TRUE(std::isinf(c.standard_errors[1]));
    EXPECT_TRUE(std::isfinite(c.standard_errors[2]));
    const auto told = principal_directions(c, {0, 1});
    EXPECT_NEAR(told[0].components[1] / told[0].components[0], .5, 1e-12);
    EXPECT_TRUE(std::isinf(told[1].standard_error));
}

}  // namespace
}  // namespace tricontact::statistics::bounded_least_squares_test

#include "statistics/distribution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tricontact::statistics::distribution_test {
namespace {

// Mean 0 and variance 1 by the midpoint rule over probabilities: its error is of second order for
// the bounded ones; the normal one has infinite ends, whose share is 1e-4 with 1e5 points.
TEST(Distribution, QuantilesHaveMeanZeroAndVarianceOne) {
    using enum Distribution;
    for (const auto one : {normal, uniform, triangular}) {
        double mean = 0, variance = 0;
        constexpr int n = 100'000;
        for (int i = 0; i < n; ++i) {
            const double x = standard_quantile(one, (i + .5) / n);
            mean += x / n;
            variance += x * x / n;
        }
        EXPECT_NEAR(mean, 0, 1e-9) << name_of(one);
        EXPECT_NEAR(variance, 1, 2e-4) << name_of(one);
    }
}

TEST(Distribution, BoundedOnesEndWhereTheirHalfWidthDoes) {
    using enum Distribution;
    for (const auto one : {uniform, triangular}) {
        EXPECT_NEAR(standard_quantile(one, 1) * standard_deviations(one), 1, 1e-12);
        EXPECT_NEAR(standard_quantile(one, 0) * standard_deviations(one), -1, 1e-12);
    }
    // P(|x| < half width/2): 1/2 of the uniform, 3/4 of the triangular one.
    EXPECT_NEAR(standard_quantile(uniform, .75) * standard_deviations(uniform), .5, 1e-12);
    EXPECT_NEAR(standard_quantile(triangular, .875) * standard_deviations(triangular), .5, 1e-12);
    EXPECT_NEAR(standard_quantile(normal, .975), 1.959963985, 1e-9);
}

}  // namespace
}  // namespace tricontact::statistics::distribution_test

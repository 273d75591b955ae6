#include "contact/solvers/fixed_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tricontact::fixed_point_test {
namespace {

using contact::FixedPoint;

/// Largest error after some iterations of x = factor x + 1, per entry.
double error_after(int n, const std::vector<double>& factors, bool accelerated) {
    std::vector<double> x(factors.size(), 0);
    FixedPoint turns;
    double error = 0;
    for (int k = 0; k < n; ++k) {
        std::vector<double> g(x.size());
        double residual = 0;
        error = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            g[i] = factors[i] * x[i] + 1;
            residual = std::max(residual, std::abs(g[i] - x[i]));
            error = std::max(error, std::abs(x[i] - 1 / (1 - factors[i])));
        }
        x = accelerated ? turns.next(x, g, residual) : g;
    }
    return error;
}

TEST(FixedPoint, AsManyStepsAsTheMapHasModes) {
    const std::vector<double> four{.9, -.7, .5, .2};
    EXPECT_LT(error_after(7, four, true), 1e-9);
    EXPECT_GT(error_after(7, four, false), 1);
}

TEST(FixedPoint, ConvergesWhereTheIterationAloneDiverges) {
    const std::vector<double> factors{-1.8, -1.2, .6, .1, -.1};
    EXPECT_LT(error_after(25, factors, true), 1e-6);
    EXPECT_GT(error_after(25, factors, false), 1e5);
}

TEST(FixedPoint, InfiniteEntriesStay) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    FixedPoint turns;
    const auto x = turns.next({1, inf}, {2, inf}, 1);
    EXPECT_EQ(x[0], 2);
    EXPECT_EQ(x[1], inf);
    EXPECT_TRUE(std::isfinite(turns.next(x, {2.5, inf}, .5)[0]));
}

}  // namespace
}  // namespace tricontact::fixed_point_test

#include "statistics/initial_sequence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/unit/statistics/autoregressive.h"

namespace tricontact::statistics::initial_sequence_test {
namespace {

struct Coverage {
    double share = 0;       // of the intervals that hold the true mean
    double mean_error = 0;  // half width, over that of the true 95 % interval
};

Coverage coverage(double rho, int n) {
    constexpr int n_series = 1000;
    std::mt19937_64 generator(20261122);
    const double truth = 1.96 * std::sqrt((1 + rho) / (1 - rho) / n);
    Coverage result;
    for (int i = 0; i < n_series; ++i) {
        const Mean mean = initial_sequence_mean(autoregressive(rho, n, generator));
        result.share += (std::abs(mean.value) <= mean.error) / double(n_series);
        result.mean_error += mean.error / truth / n_series;
    }
    return result;
}

// Of 1000 intervals 95 % are 950 +- 14 (2 s). With 200 values of a strong correlation some more
// miss: 22 independent ones at rho = 0.8 do not tell their own correlation. What alternates is
// held by intervals that are too wide.
TEST(InitialSequence, CoversTheMeanOfAnAutoregressiveProcess) {
    for (const double rho : {0., 0.3, 0.6}) {
        const auto [share, mean_error] = coverage(rho, 200);
        EXPECT_NEAR(share, 0.95, 0.025) << rho;
        EXPECT_NEAR(mean_error, 1.03, 0.06) << rho;
    }
    EXPECT_NEAR(coverage(0.8, 200).share, 0.925, 0.02);
    EXPECT_NEAR(coverage(0.8, 2000).share, 0.95, 0.02);
    EXPECT_GT(coverage(-0.5, 200).share, 0.99);
}

// (1 - rho)/(1 + rho) of them. The estimate scatters by the root of as many lags as are summed,
// some ten, over the number of values.
TEST(InitialSequence, CountsTheIndependentValuesOfAnAutoregressiveProcess) {
    std::mt19937_64 generator(20261122);
    constexpr int n = 100000;
    for (const double rho : {0., 0.3, 0.5, 0.8}) {
        const double independent = independent_values(autoregressive(rho, n, generator));
        EXPECT_NEAR(independent / n * (1 + rho) / (1 - rho), 1, 0.05) << rho;
    }
    // Not more than there are, not fewer than two.
    EXPECT_EQ(independent_values(autoregressive(-0.5, n, generator)), n);
    EXPECT_EQ(independent_values(std::vector<double>{0, 1}), 2);
}

// 18 times the autocovariances of lags 0 to 9 are 6 0 2 -1 0 2 0 2 -2 0: pairs 6, 1, 2, 2, -2. The
// last ends the sequence; the two that rise again count as the least before them, 1. The variance
// of the mean is that of independent values times (-6 + 2 (6 + 1 + 1 + 1))/6 = 2.
TEST(InitialSequence, CountsNoPairLargerThanOneBefore) {
    const std::vector<double> values{1, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, -1, 0, -1};
    EXPECT_DOUBLE_EQ(independent_values(values), 9);
}

// Of a few independent values it is Student's interval, here of 0 and 1: 12.7 times 1/2.
TEST(InitialSequence, OfTwoValuesIsStudents) {
    const Mean mean = initial_sequence_mean(std::vector<double>{0, 1});
    EXPECT_EQ(mean.value, 0.5);
    EXPECT_NEAR(mean.error, 12.706 / 2, 1e-3);
}

TEST(InitialSequence, OfAConstantHasNoError) {
    const Mean mean = initial_sequence_mean(std::vector<double>(10, 0.25));
    EXPECT_EQ(mean.value, 0.25);
    EXPECT_EQ(mean.error, 0);
}

}  // namespace
}  // namespace tricontact::statistics::initial_sequence_test

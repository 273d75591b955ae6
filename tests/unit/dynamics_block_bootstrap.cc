#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "dynamics/block_bootstrap.h"
#include "dynamics_autoregressive.h"

namespace tricontact::dynamics {
namespace {

struct Coverage {
    double share = 0;       // of the intervals that hold the true mean
    double mean_error = 0;  // half width, over that of the true 95 % interval
};

Coverage coverage(double rho, int n, int n_series) {
    std::mt19937_64 generator(20261122);
    const double truth = 1.96 * std::sqrt((1 + rho) / (1 - rho) / n);
    Coverage result;
    for (int i = 0; i < n_series; ++i) {
        const Mean mean = block_bootstrap_mean(autoregressive(rho, n, generator));
        result.share += (std::abs(mean.value) <= mean.error) / static_cast<double>(n_series);
        result.mean_error += mean.error / truth / n_series;
    }
    return result;
}

// Of 300 intervals 95 % are 285 +- 8 (2 s). With 200 values a block bootstrap misses some of a
// strong correlation, by its nature: the variance it estimates is too small by the order of
// block/n.
TEST(BlockBootstrap, CoversTheMeanOfAnAutoregressiveProcess) {
    const Coverage white = coverage(0, 200, 300), weak = coverage(0.3, 200, 300),
                   strong = coverage(0.6, 200, 300);
    EXPECT_NEAR(white.share, 0.95, 0.025);
    EXPECT_NEAR(white.mean_error, 1, 0.05);
    EXPECT_NEAR(weak.share, 0.94, 0.03);
    EXPECT_NEAR(weak.mean_error, 0.96, 0.06);
    EXPECT_NEAR(strong.share, 0.92, 0.04);
    EXPECT_NEAR(strong.mean_error, 0.93, 0.08);
}

// Politis and White (2004): the best length is (2 G^2/D n)^(1/3), for this process
// (6 rho^2/(1 - rho^2)^2 n)^(1/3).
TEST(BlockBootstrap, TakesTheBestLengthOfAnAutoregressiveProcess) {
    std::mt19937_64 generator(20261122);
    for (const double rho : {0.3, 0.5, 0.7}) {
        constexpr int n = 10000, n_series = 20;
        double mean = 0;
        for (int i = 0; i < n_series; ++i)
            mean += block_length(autoregressive(rho, n, generator)) / double(n_series);
        const double best = std::cbrt(6 * rho * rho / std::pow(1 - rho * rho, 2) * n);
        EXPECT_NEAR(mean / best, 1, 0.15) << rho;  // the estimate converges as n^(-1/3)
    }
}

TEST(BlockBootstrap, OfAConstantHasNoError) {
    const Mean mean = block_bootstrap_mean(std::vector<double>(10, 0.25));
    EXPECT_EQ(mean.value, 0.25);
    EXPECT_EQ(mean.error, 0);
}

TEST(BlockBootstrap, TellsTheSameTwice) {
    std::mt19937_64 generator(1);
    const auto values = autoregressive(0.5, 100, generator);
    EXPECT_EQ(block_bootstrap_mean(values).error, block_bootstrap_mean(values).error);
}

}  // namespace
}  // namespace tricontact::dynamics

#include "experiments/records/record_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tricontact::experiments::record_noise_test {
namespace {

// Autoregressive of first order: rho(k) = correlation^k, unit variance.
std::vector<double> noise(std::size_t n, double correlation, std::mt19937_64& random) {
    std::normal_distribution<double> gauss;
    std::vector<double> values;
    double now = gauss(random);
    for (std::size_t i = 0; i < n; ++i) {
        values.push_back(now);
        now = correlation * now + std::sqrt(1 - correlation * correlation) * gauss(random);
    }
    return values;
}

TEST(RecordNoise, ErrorOfAMeanCountsCorrelatedSamples) {
    std::mt19937_64 random(1);
    for (const double correlation : {0., 0.5, 0.8}) {
        const RecordNoise seen(noise(20000, correlation, random), 0);
        // Priestley (1981), 5.3.5: variance of a mean of n is sigma^2/n (1 + r)/(1 - r) to 1/n.
        const double n = 400, factor = (1 + correlation) / (1 - correlation);
        const std::vector<double> weights(400, 1 / n);
        // The sum of estimated correlations scatters by some 10 % at 20000 values.
        EXPECT_NEAR(seen.standard_error(weights), std::sqrt(factor / n),
                    0.1 * std::sqrt(factor / n));
        EXPECT_NEAR(seen.correlated_samples, factor, 0.25 * factor);
        EXPECT_NEAR(seen.standard_deviation, 1, 0.05);
    }
}

// A straight line through n values leaves n - 2 degrees of freedom, exactly: 1, -2, 1 are what it
// leaves of 1, -1, 3 at three places. Their variance is 6/1.
TEST(RecordNoise, DeviationIsThatOfResidualsOfALine) {
    EXPECT_DOUBLE_EQ(RecordNoise({1, -2, 1}, 0).standard_deviation, std::sqrt(6));
    EXPECT_DOUBLE_EQ(RecordNoise({1, -1, -1, 1}, 0).standard_deviation, std::sqrt(2));
    EXPECT_THROW(RecordNoise({1, -1}, 0), std::invalid_argument);
}

TEST(RecordNoise, RoundingWithoutNoiseDoesNotAverageOut) {
    const RecordNoise quiet(std::vector<double>(100, 0.), 80e-9);
    EXPECT_DOUBLE_EQ(quiet.standard_error(std::vector<double>(50, 0.02)), 80e-9 / std::sqrt(12));
    std::mt19937_64 random(2);
    std::vector<double> loud = noise(100, 0, random);
    const RecordNoise dithered(loud, 0.5);  // noise of 1 crosses steps of 0.5
    EXPECT_LT(dithered.standard_error(std::vector<double>(50, 0.02)), 0.2);
}

TEST(RecordNoise, WeightsOfAPolynomialReproduceIt) {
    const std::vector<double> x{0, 1, 2.5, 3, 7}, y{2, 5, 9.5, 11, 23};  // 2 + 3 x
    EXPECT_NEAR(weighted(weights_of_slope(x), y), 3, 1e-14);
    for (const int degree : {1, 2, 3})
        EXPECT_NEAR(weighted(weights_of_polynomial_at(-2, x, degree), y), -4, 1e-12);
    EXPECT_NEAR(weighted(weights_of_polynomial_at(-2, x, 0), y), 10.1, 1e-13);
    // x^2 at 1.5 from three places, which determine no more than three coefficients.
    for (const int degree : {2, 5})
        EXPECT_NEAR(weighted(weights_of_polynomial_at(1.5, {0, 1, 3}, degree), {0, 1, 9}), 2.25,
                    1e-12);
    EXPECT_EQ(weights_of_polynomial_at(0, {2, 2}, 2), (std::vector<double>{0.5, 0.5}));
    EXPECT_THROW(weights_of_slope({1, 1}), std::invalid_argument);
}

TEST(RecordNoise, ResolutionIsTheSmallestStep) {
    EXPECT_NEAR(smallest_step({0.16e-6, 0.08e-6, 0.4e-6, 0.16e-6}), 0.08e-6, 1e-20);
    EXPECT_EQ(smallest_step({3, 3, 3}), 0);
}

}  // namespace
}  // namespace tricontact::experiments::record_noise_test

#include "statistics/ensemble_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "contact/base/error.h"
#include "statistics/latin_hypercube.h"

namespace tricontact::statistics::ensemble_sampler_test {
namespace {

std::vector<std::vector<double>> walkers_around(const std::vector<double>& centre,
                                                const std::vector<double>& scale, int n) {
    SplitMix64 random(7);
    std::vector<std::vector<double>> walkers;
    for (int i = 0; i < n; ++i) {
        walkers.push_back(centre);
        for (std::size_t d = 0; d < centre.size(); ++d)
            walkers.back()[d] += scale[d] * (random.uniform() - .5);
    }
    return walkers;
}

struct Moments {
    double mean_x, mean_y, variance_x, variance_y, correlation;
};
Moments moments(const EnsembleSample& sample) {
    Moments m{};
    const auto n = static_cast<double>(sample.points.size());
    for (const auto& p : sample.points) {
        m.mean_x += p[0] / n;
        m.mean_y += p[1] / n;
    }
    double product = 0;
    for (const auto& p : sample.points) {
        m.variance_x += std::pow(p[0] - m.mean_x, 2) / n;
        m.variance_y += std::pow(p[1] - m.mean_y, 2) / n;
        product += (p[0] - m.mean_x) * (p[1] - m.mean_y) / n;
    }
    m.correlation = product / std::sqrt(m.variance_x * m.variance_y);
    return m;
}

// A normal density of E about 5e6 and mu about 0.6, scales apart by 1e7, correlated by -0.95: mean
// and variance to four standard errors of as many independent draws.
TEST(EnsembleSampler, FindsACorrelatedNormalDensity) {
    constexpr double r = -.95, sx = 2e5, sy = .02;
    const auto log_density = [](const std::vector<double>& p) {
        const double x = (p[0] - 5e6) / sx, y = (p[1] - .6) / sy;
        return -(x * x - 2 * r * x * y + y * y) / (2 * (1 - r * r));
    };
    const auto sample = sample_ensemble(log_density, walkers_around({5e6, .6}, {1e4, 1e-3}, 20), 1);
    const double error = 4 / std::sqrt(sample.effective_size());
    const Moments m = moments(sample);
    EXPECT_GT(sample.effective_size(), 500);
    EXPECT_NEAR((m.mean_x - 5e6) / sx, 0, error);
    EXPECT_NEAR((m.mean_y - .6) / sy, 0, error);
    EXPECT_NEAR(m.variance_x / (sx * sx), 1, error * std::sqrt(2));
    EXPECT_NEAR(m.variance_y / (sy * sy), 1, error * std::sqrt(2));
    EXPECT_NEAR(m.correlation, r, 4 * (1 - r * r) / std::sqrt(sample.effective_size()));
    EXPECT_GT(sample.acceptance, .3);
}

// x normal, y = x^2 + normal of deviation 1/2: mean 1, variance 2 + 1/4, no correlation.
TEST(EnsembleSampler, FindsABananasMoments) {
    const auto log_density = [](const std::vector<double>& p) {
        return -p[0] * p[0] / 2 - 2 * std::pow(p[1] - p[0] * p[0], 2);
    };
    const auto sample = sample_ensemble(log_density, walkers_around({0, 0}, {1, 1}, 40), 2);
    const double error = 4 / std::sqrt(sample.effective_size());
    const Moments m = moments(sample);
    EXPECT_NEAR(m.mean_x, 0, error);
    EXPECT_NEAR(m.mean_y, 1, 1.5 * error);
    EXPECT_NEAR(m.variance_x, 1, error * std::sqrt(2));
    EXPECT_NEAR(m.variance_y, 2.25, 2.25 * error * std::sqrt(7));  // kurtosis of x^2: 15
}

// Uniform on a triangle: nothing beyond the edges, mean at a third.
TEST(EnsembleSampler, StaysWhereTheDensityIsPositive) {
    const auto log_density = [](const std::vector<double>& p) {
        const bool inside = p[0] > 0 && p[1] > 0 && p[0] + p[1] < 1;
        return inside ? 0 : -std::numeric_limits<double>::infinity();
    };
    const auto sample = sample_ensemble(log_density, walkers_around({.3, .3}, {.1, .1}, 20), 3);
    for (const auto& p : sample.points) ASSERT_TRUE(p[0] > 0 && p[1] > 0 && p[0] + p[1] < 1);
    const Moments m = moments(sample);
    const double error = 4 * std::sqrt(1. / 18) / std::sqrt(sample.effective_size());
    EXPECT_NEAR(m.mean_x, 1. / 3, error);
    EXPECT_NEAR(m.mean_y, 1. / 3, error);
    EXPECT_THROW(sample_ensemble(log_density, walkers_around({2, 2}, {.1, .1}, 20), 3),
                 std::invalid_argument);
    EXPECT_THROW(sample_ensemble(log_density, walkers_around({.3, .3}, {.1, .1}, 3), 3),
                 std::invalid_argument);
}

// 250 steps are fewer than 50 autocorrelation times.
TEST(EnsembleSampler, SaysWhereItDoesNotSettle) {
    const auto log_density = [](const std::vector<double>& p) {
        return -p[0] * p[0] / 2 - 2 * std::pow(p[1] - p[0] * p[0], 2);
    };
    EXPECT_THROW(sample_ensemble(log_density, walkers_around({0, 0}, {1, 1}, 8), 4, 500),
                 contact::NotConverged);
}

}  // namespace
}  // namespace tricontact::statistics::ensemble_sampler_test

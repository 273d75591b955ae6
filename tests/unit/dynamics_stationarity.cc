#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "dynamics/stationarity.h"
#include "dynamics_autoregressive.h"

namespace tricontact::dynamics {
namespace {

constexpr double rho = 0.3;
constexpr int n = 200;

// A decaying start of height 10 and life 10 is as large as the noise after 23 values, and is left
// out about there. Without that the mean would be 0.5; what remains is less than the error of the
// mean, 0.096, because that is what the rule makes least.
TEST(Stationarity, LeavesOutADecayingStart) {
    std::mt19937_64 generator(20261122);
    constexpr int n_series = 200;
    double left_out = 0, mean = 0;
    for (int i = 0; i < n_series; ++i) {
        auto values = autoregressive(rho, n, generator);
        for (int k = 0; k < n; ++k) values[static_cast<std::size_t>(k)] += 10 * std::exp(-k / 10.);
        const std::size_t first = transient_values(values);
        left_out += static_cast<double>(first) / n_series;
        double sum = 0;
        for (std::size_t k = first; k < values.size(); ++k) sum += values[k];
        mean += sum / static_cast<double>(values.size() - first) / n_series;
    }
    EXPECT_NEAR(left_out, 23, 8);
    EXPECT_LT(std::abs(mean), 0.096);
}

TEST(Stationarity, LeavesOutLittleOfWhatHasNoTransient) {
    std::mt19937_64 generator(20261122);
    double left_out = 0;
    constexpr int n_series = 200;
    for (int i = 0; i < n_series; ++i)
        left_out += static_cast<double>(transient_values(autoregressive(rho, n, generator))) /
                    (n_series * static_cast<double>(n));
    EXPECT_LT(left_out, 0.1);
}

TEST(Stationarity, LeavesOutHalfWhereTheTransientIsLonger) {
    std::vector<double> values;
    for (int k = 0; k < n; ++k) values.push_back(1 - k / 200.);
    EXPECT_EQ(transient_values(values), values.size() / 2);
}

// 3 in 1000 false alarms, some more as the intervals of correlated values are a little narrow.
TEST(Stationarity, IsTrueOfAStationaryProcess) {
    std::mt19937_64 generator(20261122);
    int n_stationary = 0;
    for (int i = 0; i < 200; ++i) n_stationary += stationary(autoregressive(rho, n, generator));
    EXPECT_GE(n_stationary, 195);
}

// A step of one standard deviation of the values is six of the difference of the means.
TEST(Stationarity, IsFalseOfAStep) {
    std::mt19937_64 generator(20261122);
    for (int i = 0; i < 20; ++i) {
        auto values = autoregressive(rho, n, generator);
        for (std::size_t k = 120; k < values.size(); ++k) values[k] += 1;
        EXPECT_FALSE(stationary(values));
    }
}

}  // namespace
}  // namespace tricontact::dynamics

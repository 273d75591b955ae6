#include "statistics/stationarity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/unit/statistics/autoregressive.h"

namespace tricontact::statistics::stationarity_test {
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

template <class Course>
std::vector<std::vector<double>> series(int length, Course course) {
    std::vector<std::vector<double>> points;
    for (int i = 0; i < length; ++i) points.push_back(course(i));
    return points;
}

// A way that shortens by a factor r in each third: up to 0.48 the means of its halves differ by
// more than the mean of the whole is off its end, and it does not creep; beyond they do not.
TEST(Stationarity, WhatCreepsHasAnEndThatItsHalvesDoNotTell) {
    constexpr int length = 3000;
    for (const double r : {0.2, 0.45, 0.5, 0.8}) {
        const auto way =
            series(length, [=](int i) { return std::vector{std::pow(r, 3. * i / length)}; });
        double first = 0, last = 0;
        for (int i = 0; i < length; ++i)
            (2 * i < length ? first : last) += 2 * way[static_cast<std::size_t>(i)][0] / length;
        EXPECT_EQ(creeps(way, 0), (first + last) / 2 > first - last) << r;
        EXPECT_EQ(creeps(way, 0), r > 0.48) << r;
    }
}

TEST(Stationarity, WhatScattersDoesNotCreep) {
    std::mt19937_64 generator(20261122);
    std::normal_distribution<double> normal;
    const auto noise = [&](int) { return std::vector{normal(generator), normal(generator)}; };
    int n_creeping = 0;
    for (int i = 0; i < 200; ++i) n_creeping += creeps(series(48, noise), 0);
    EXPECT_EQ(n_creeping, 0);
    // Along a line, as far as the integration errs and farther: by 16 a third.
    const auto line = series(48, [](int i) { return std::vector{3. * i, 4. * i}; });
    EXPECT_TRUE(creeps(line, 5 * 15.9));
    EXPECT_FALSE(creeps(line, 5 * 16.1));
    EXPECT_FALSE(creeps(std::span(line).first(5), 0));
}

}  // namespace
}  // namespace tricontact::statistics::stationarity_test

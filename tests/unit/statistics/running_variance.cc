#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "statistics/spectrum.h"

namespace tricontact::statistics::running_variance_test {
namespace {

double variance(std::span<const double> values) {
    double mean = 0, squares = 0;
    for (const double value : values) mean += value / static_cast<double>(values.size());
    for (const double value : values) squares += (value - mean) * (value - mean);
    return squares / static_cast<double>(values.size());
}

TEST(RunningVariance, IsThatOfEachWindow) {
    std::vector<double> values;
    for (int i = 0; i < 50; ++i) values.push_back(1000 + std::sin(0.7 * i) + 0.01 * i * i);
    const auto result = running_variance(values, 12);
    ASSERT_EQ(result.size(), 39u);
    for (std::size_t i = 0; i < result.size(); ++i)
        EXPECT_NEAR(result[i], variance(std::span(values).subspan(i, 12)), 1e-9 * result[i]);
}

// A sine of amplitude A has the variance A^2/2 over whole periods, silence has none: vibrating for
// the first 600 of 1000 values, 10 periods of 20 values to a window, seen above half of A^2/2 while
// more than half of the window vibrates.
TEST(RunningVariance, TellsForWhichShareOfTheTimeItVibrates) {
    std::vector<double> values(1000, 0.3);
    for (int i = 0; i < 600; ++i) values[i] += 2 * std::sin(2 * std::numbers::pi * i / 20);
    const auto result = running_variance(values, 200);
    ASSERT_EQ(result.size(), 801u);
    EXPECT_NEAR(result.front(), 2, 1e-12);
    EXPECT_NEAR(result.back(), 0, 1e-12);
    EXPECT_NEAR(share_above(result, 1), 500. / 801, 20. / 801);  // to a period
}

TEST(RunningVariance, OfTooFewValuesIsUndefined) {
    EXPECT_TRUE(running_variance(std::vector<double>{1, 2}, 3).empty());
    EXPECT_TRUE(std::isnan(share_above({}, 1)));
}

}  // namespace
}  // namespace tricontact::statistics::running_variance_test

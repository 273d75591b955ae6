#include "statistics/sobol_indices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::statistics::sobol_indices_test {
namespace {

using std::numbers::pi;

// Ishigami and Homma (1990), a = 7, b = 0.1; its indices in closed form (Saltelli et al. 2008,
// Global Sensitivity Analysis, section 4.6). 2^14 samples leave less than 1 % of the variance.
TEST(SobolIndices, AreThoseOfIshigamisFunction) {
    constexpr double a = 7, b = .1;
    const auto sample = sobol_indices(
        [](const std::vector<double>& u) -> std::vector<double> {
            const auto x = [&](int i) { return pi * (2 * u[i] - 1); };
            return {std::sin(x(0)) + a * std::pow(std::sin(x(1)), 2) +
                    b * std::pow(x(2), 4) * std::sin(x(0))};
        },
        3, 1 << 14);
    const double one = std::pow(1 + b * std::pow(pi, 4) / 5, 2) / 2, two = a * a / 8,
                 three = b * b * std::pow(pi, 8) * (1. / 18 - 1. / 50), all = one + two + three;
    const SobolIndices& found = sample.indices.front();
    EXPECT_NEAR(found.mean, a / 2, .01 * std::sqrt(all));
    EXPECT_NEAR(found.variance / all, 1, .01);
    const double first[] = {one / all, two / all, 0},
                 total[] = {(one + three) / all, two / all, three / all};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(found.first[i], first[i], .01) << i;
        EXPECT_NEAR(found.total[i], total[i], .01) << i;
    }
}

// The error falls nearly as 1/n, much faster than the 1/sqrt(n) of random points: by 8 and more
// from 2^8 to 2^12 samples.
TEST(SobolIndices, ConvergeFasterThanRandomSamples) {
    const auto error = [](int n) {
        const auto sample = sobol_indices(
            [](const std::vector<double>& u) -> std::vector<double> {
                return {std::exp(u[0]) + u[1] * u[1]};
            },
            2, n);
        const double e = std::numbers::e, one = (e * e - 1) / 2 - (e - 1) * (e - 1),
                     two = 1. / 5 - 1. / 9;
        return std::abs(sample.indices[0].first[0] - one / (one + two)) +
               std::abs(sample.indices[0].first[1] - two / (one + two));
    };
    EXPECT_LT(error(1 << 12), error(1 << 8) / 8);
}

TEST(SobolIndices, LeaveOutWhatIsNotDefined) {
    const auto sample = sobol_indices(
        [](const std::vector<double>& u) -> std::vector<double> {
            return {u[0] < .9 ? u[0] : std::nan(""), u[1], 3};
        },
        2, 1 << 12);
    EXPECT_NEAR(sample.indices[0].mean, .45, .01);
    EXPECT_NEAR(sample.indices[1].first[1], 1, .01);
    EXPECT_NEAR(sample.indices[1].total[0], 0, .01);
    EXPECT_EQ(sample.indices[2].variance, 0);
    EXPECT_EQ(sample.points.size(), 1U << 13);
    EXPECT_THROW(sobol_indices({}, 21, 100), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::statistics::sobol_indices_test

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/substrates/partly_relaxing_substrate.h"

namespace tricontact::stieltjes_interpolation_test {
namespace {

using contact::StieltjesInterpolation;

/// The largest relative error for C(x) = 1/(x + l), over x in [1, range] and l in [0, infinity].
double worst_error(const StieltjesInterpolation& interpolation, double range) {
    double worst = 0;
    for (int i = 0; i <= 100; ++i) {
        const double x = std::pow(range, i / 100.);
        const auto shares = interpolation.shares(x);
        auto error = [&](auto&& c) {
            double sum = 0;
            for (std::size_t j = 0; j < shares.size(); ++j)
                sum += shares[j] * c(interpolation.nodes[j]);
            return std::abs(sum / c(x) - 1);
        };
        worst = std::max(worst, error([](double) { return 1; }));  // l infinite
        worst = std::max(worst, error([](double y) { return 1 / y; }));
        for (int k = -60; k <= 60; ++k)
            worst = std::max(worst,
                             error([l = std::pow(10, k / 10.)](double y) { return 1 / (y + l); }));
    }
    return worst;
}

TEST(StieltjesInterpolation, ErrorIsBoundedWhateverTheBody) {
    for (const double range : {1.001, 1.3, 2.7, 30., 1e4})
        for (const double error : {1e-2, 1e-4, 1e-8}) {
            const StieltjesInterpolation interpolation(range, error);
            EXPECT_LE(interpolation.error, error);
            EXPECT_GE(interpolation.range, range);
            const double worst = worst_error(interpolation, interpolation.range);
            // The bound is met by some body; beyond it there is rounding alone, of weights 1e6.
            EXPECT_LT(worst, 1.001 * interpolation.error + 1e-8) << range << ' ' << error;
            if (error > 1e-8) {
                EXPECT_GT(worst, .5 * interpolation.error) << range << ' ' << error;
            }
            for (const double x : interpolation.nodes) EXPECT_GT(x, 1);
            for (const double a : interpolation.poles) EXPECT_GT(a, 0);
        }
}

// Few points, and as many more for each further digit.
TEST(StieltjesInterpolation, ConvergesExponentially) {
    EXPECT_EQ(StieltjesInterpolation(2, 1e-8).size(), 7u);
    EXPECT_EQ(StieltjesInterpolation(1e4, 1e-8).size(), 25u);
    auto size = [](double error) {
        return static_cast<double>(StieltjesInterpolation(30, error).size());
    };
    EXPECT_NEAR(size(1e-12) - size(1e-8), size(1e-8) - size(1e-4), 1);
}

// However small or large the range, weights of either sign stay small against what they add up to.
TEST(StieltjesInterpolation, WeightsAreSmall) {
    for (double excess = 1e-12; excess < 1e6; excess *= 3) {
        const StieltjesInterpolation interpolation(1 + excess, 1e-8);
        for (std::size_t m = 0; m < interpolation.size(); ++m)
            for (std::size_t j = 0; j < interpolation.size(); ++j)
                EXPECT_LT(std::abs(interpolation.weight(m, j)) /
                              (interpolation.nodes[j] + interpolation.poles[m]),
                          1e6)
                    << excess;
    }
}

TEST(StieltjesInterpolation, NeedsARange) {
    EXPECT_THROW(StieltjesInterpolation(1, 1e-7), std::logic_error);
    EXPECT_THROW(StieltjesInterpolation(2, 0), std::logic_error);
}

}  // namespace
}  // namespace tricontact::stieltjes_interpolation_test

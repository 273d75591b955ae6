#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/stieltjes_interpolation.h"

namespace tricontact {
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
                sum += shares[j] * c(interpolation.nodes()[j]);
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
        for (const double error : {1e-2, 1e-4, 1e-7}) {
            const StieltjesInterpolation interpolation(range, error);
            EXPECT_LE(interpolation.error(), error);
            const double worst = worst_error(interpolation, range);
            // The bound is met by some body; beyond it there is rounding alone, of weights 1e6 and
            // more.
            EXPECT_LT(worst, 1.001 * interpolation.error() + 5e-9) << range << ' ' << error;
            if (error > 1e-7) {
                EXPECT_GT(worst, .5 * interpolation.error()) << range << ' ' << error;
            }
            for (const double x : interpolation.nodes()) EXPECT_TRUE(x > 1 && x < range);
            for (const double a : interpolation.poles()) EXPECT_GT(a, 0);
        }
}

// Few points: a modulus that doubles needs seven for 1e-7 or less, one that grows 1e4 times 22.
TEST(StieltjesInterpolation, ConvergesExponentially) {
    EXPECT_LE(StieltjesInterpolation(2, 1e-7).size(), 7u);
    EXPECT_LE(StieltjesInterpolation(1e4, 1e-7).size(), 22u);
    const double third = StieltjesInterpolation(10, 1e-3).error();
    const auto n = StieltjesInterpolation(10, 1e-3).size();
    EXPECT_EQ(StieltjesInterpolation(10, third * third / 3).size(), 2 * n);  // 4 q^n: a factor 4
}

TEST(StieltjesInterpolation, NeedsARange) {
    EXPECT_THROW(StieltjesInterpolation(1, 1e-7), std::logic_error);
    EXPECT_THROW(StieltjesInterpolation(2, 0), std::logic_error);
}

}  // namespace
}  // namespace tricontact

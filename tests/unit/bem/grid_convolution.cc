#include "bem/grid_convolution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace tricontact::grid_convolution_test {
namespace {

using bem::GridConvolution;

double even_kernel(int i, int j) {
    return 1 / (1. + i * i + 2 * j * j);
}
double odd_kernel(int i, int j) {
    return i * j / (1. + i * i + 2 * j * j);
}
double other_kernel(int i, int j) {
    return std::exp(-.1 * (2 * i * i + j * j));
}

void apply(const GridConvolution& convolution, const GridConvolution::Symbol& kernel,
           std::span<const double> in, std::span<double> out) {
    convolution.apply<1, 1>({{{&kernel}}}, {in}, {out});
}

void apply(const GridConvolution& convolution, const GridConvolution::Symbol2& kernels,
           std::span<const double> x, std::span<const double> y, std::span<double> out_x,
           std::span<double> out_y) {
    convolution.apply<2, 2>({{{&kernels.xx, &kernels.xy}, {&kernels.xy, &kernels.yy}}}, {x, y},
                            {out_x, out_y});
}

std::vector<double> field(int n, double seed) {
    std::vector<double> f(n);
    for (int k = 0; k < n; ++k) f[k] = std::sin(seed * (k + 1) * (k + 1));
    return f;
}

template <typename Kernel>
std::vector<double> direct_sum(int n_x, int n_y, Kernel kernel, const std::vector<double>& in) {
    std::vector<double> out(in.size(), 0.);
    for (int j = 0; j < n_y; ++j)
        for (int i = 0; i < n_x; ++i)
            for (int l = 0; l < n_y; ++l)
                for (int k = 0; k < n_x; ++k)
                    out[j * n_x + i] += kernel(i - k, j - l) * in[l * n_x + k];
    return out;
}

void expect_equal(const std::vector<double>& a, const std::vector<double>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
        ASSERT_NEAR(a[k], b[k], 1e-13) << k;  // rounding of sums of order ten
}

// Odd, even, narrower than one piece of rows, single rows and cells.
const std::pair<int, int> sizes[] = {{5, 7},  {12, 9},  {8, 8},   {1, 1}, {1, 13},
                                     {17, 1}, {31, 20}, {20, 31}, {11, 3}};

TEST(GoodFftSize, SmallestEvenProductOfSmallPrimes) {
    const int expected[][2] = {{1, 2},     {2, 2},     {3, 4},     {11, 12},
                               {13, 14},   {17, 18},   {22, 24},   {23, 24},
                               {101, 108}, {125, 126}, {127, 128}, {2047, 2048}};
    for (const auto& [n, size] : expected) EXPECT_EQ(bem::good_fft_size(n), size) << n;
}

TEST(GoodFftSize, WithoutNineForComplexTransforms) {
    const int expected[][2] = {{1, 2}, {17, 20}, {23, 24}, {89, 96}, {101, 112}, {125, 128}};
    for (const auto& [n, size] : expected) EXPECT_EQ(bem::good_complex_fft_size(n), size) << n;
}

TEST(GridConvolution, EqualsTheDirectSum) {
    for (const auto& [n_x, n_y] : sizes)
        for (const bool tight : {true, false}) {
            // every period from 2 n - 1 on is linear
            auto period = [&](int n) { return tight ? 2 * n - 1 : bem::good_fft_size(2 * n + 5); };
            const GridConvolution convolution(n_x, n_y, period(n_x), period(n_y), 1);
            const auto in = field(n_x * n_y, .7);
            std::vector<double> out(in.size());
            for (const auto kernel : {even_kernel, odd_kernel}) {
                apply(convolution, convolution.symbol(kernel), in, out);
                SCOPED_TRACE(testing::Message() << n_x << ' ' << n_y << ' ' << tight);
                expect_equal(out, direct_sum(n_x, n_y, kernel, in));
            }
        }
}

TEST(GridConvolution, MatrixOfKernels) {
    for (const auto& [n_x, n_y] : sizes) {
        const GridConvolution convolution(n_x, n_y, bem::good_fft_size(2 * n_x - 1),
                                          bem::good_fft_size(2 * n_y - 1), 1);
        const GridConvolution::Symbol2 symbol{convolution.symbol(even_kernel),
                                              convolution.symbol(odd_kernel),
                                              convolution.symbol(other_kernel)};
        const auto x = field(n_x * n_y, .7), y = field(n_x * n_y, 1.9);
        std::vector<double> out_x(x.size()), out_y(x.size());
        apply(convolution, symbol, x, y, out_x, out_y);
        auto expected_x = direct_sum(n_x, n_y, even_kernel, x);
        auto expected_y = direct_sum(n_x, n_y, odd_kernel, x);
        const auto xy = direct_sum(n_x, n_y, odd_kernel, y);
        const auto yy = direct_sum(n_x, n_y, other_kernel, y);
        for (std::size_t k = 0; k < x.size(); ++k) {
            expected_x[k] += xy[k];
            expected_y[k] += yy[k];
        }
        expect_equal(out_x, expected_x);
        expect_equal(out_y, expected_y);
    }
}

TEST(GridConvolution, PeriodicWithoutPadding) {
    for (const auto& [n_x, n_y] : {std::pair{5, 7}, std::pair{12, 9}, std::pair{8, 10}}) {
        auto wrap = [](int i, int n) {
            i = (i % n + n) % n;
            return i <= n / 2 ? i : i - n;
        };
        auto periodic = [&, n_x = n_x, n_y = n_y](int i, int j) {
            return even_kernel(wrap(i, n_x), wrap(j, n_y));
        };
        const GridConvolution convolution(n_x, n_y, n_x, n_y, 1);
        const auto in = field(n_x * n_y, .7);
        std::vector<double> out(in.size());
        apply(convolution, convolution.symbol(even_kernel), in, out);
        expect_equal(out, direct_sum(n_x, n_y, periodic, in));
    }
}

TEST(GridConvolution, LeavesNothingBehind) {
    const GridConvolution convolution(12, 9, 24, 18, 1);
    const auto symbol = convolution.symbol(even_kernel);
    const auto in = field(108, .7), other = field(108, 1.3);
    std::vector<double> first(108), again(108);
    apply(convolution, symbol, in, first);
    apply(convolution, symbol, other, again);
    apply(convolution, symbol, in, again);
    EXPECT_EQ(first, again);  // bit by bit
    auto in_place = in;
    apply(convolution, symbol, in_place, in_place);
    EXPECT_EQ(first, in_place);
}

TEST(GridConvolution, ThreadsDoNotChangeABit) {
    for (const auto& [n_x, n_y] : {std::pair{64, 37}, std::pair{101, 200}, std::pair{5, 7}}) {
        const int p_x = bem::good_fft_size(2 * n_x - 1), p_y = bem::good_fft_size(2 * n_y - 1);
        const GridConvolution one(n_x, n_y, p_x, p_y, 1), two(n_x, n_y, p_x, p_y, 2),
            five(n_x, n_y, p_x, p_y, 5);
        const auto x = field(n_x * n_y, .7), y = field(n_x * n_y, 1.9);
        auto run = [&](const GridConvolution& convolution) {
            const GridConvolution::Symbol2 symbol{convolution.symbol(even_kernel),
                                                  convolution.symbol(odd_kernel),
                                                  convolution.symbol(other_kernel)};
            std::vector<double> out(3 * x.size());
            const std::span<double> all(out);
            apply(convolution, symbol, x, y, all.first(x.size()), all.subspan(x.size(), x.size()));
            apply(convolution, symbol.xx, x, all.last(x.size()));
            return out;
        };
        const auto expected = run(one);
        EXPECT_EQ(run(two), expected) << n_x;
        EXPECT_EQ(run(five), expected) << n_x;
    }
}

}  // namespace
}  // namespace tricontact::grid_convolution_test

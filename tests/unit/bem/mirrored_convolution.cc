// Half of a plane against the direct sum over all of it.

#include "bem/mirrored_convolution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace tricontact::mirrored_convolution_test {
namespace {

using bem::GridConvolution;
using bem::MirroredConvolution;
using Field = std::vector<double>;

/// By its parities, as the influence coefficients xx, xy, yy, xz, yz, zz have them.
struct Kernel {
    bool odd_x, odd_y;
    double width;

    double operator()(int i, int j) const {
        return (odd_x ? i : 1) * (odd_y ? j : 1) / (width + i * i + 2 * j * j);
    }
    GridConvolution::Symbol symbol(const MirroredConvolution& convolution) const {
        return convolution.symbol(
            *this, odd_x != odd_y ? GridConvolution::Parity::odd : GridConvolution::Parity::even);
    }
};

constexpr Kernel xx{false, false, 1}, xy{true, true, 1.5}, yy{false, false, 2}, zz{false, false, 3},
    xz{true, false, 1}, yz{false, true, 1.2};

struct Grid {
    int n_x, n_y;

    Field field(double seed, bool odd) const {
        Field f(n_x * n_y);
        for (int k = 0; k < n_x * n_y; ++k)
            f[k] = odd && k < n_x ? 0 : std::sin(seed * (k + 1) * (k + 1));
        return f;
    }
    /// At (i, j), j of either sign.
    double at(const Field& f, bool odd, int i, int j) const {
        return (odd && j < 0 ? -1 : 1) * f[std::abs(j) * n_x + i];
    }
    Field direct_sum(const Kernel& kernel, const Field& f, bool odd) const {
        Field out(f.size());
        for (int j = 0; j < n_y; ++j)
            for (int i = 0; i < n_x; ++i)
                for (int l = -n_y + 1; l < n_y; ++l)
                    for (int k = 0; k < n_x; ++k)
                        out[j * n_x + i] += kernel(i - k, j - l) * at(f, odd, k, l);
        return out;
    }
    MirroredConvolution convolution(bool tight) const {
        auto period = [&](int n) { return tight ? 2 * n - 1 : bem::good_fft_size(2 * n + 5); };
        return {n_x, n_y, period(n_x), period(2 * n_y - 1), 1};
    }
};

Field sum(const Field& a, double factor, const Field& b) {
    Field c = a;
    for (std::size_t k = 0; k < c.size(); ++k) c[k] += factor * b[k];
    return c;
}

void expect_equal(const Field& a, const Field& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
        ASSERT_NEAR(a[k], b[k], 2e-13) << k;  // rounding of sums of order twenty
}

void compare(const Grid& grid, bool tight) {
    SCOPED_TRACE(testing::Message() << grid.n_x << ' ' << grid.n_y << ' ' << tight);
    const MirroredConvolution convolution = grid.convolution(tight);
    const auto of_xx = xx.symbol(convolution), of_xy = xy.symbol(convolution),
               of_yy = yy.symbol(convolution), of_zz = zz.symbol(convolution),
               of_xz = xz.symbol(convolution), of_yz = yz.symbol(convolution);
    const Field p = grid.field(.7, false), t_x = grid.field(.3, false), t_y = grid.field(.9, true);
    Field a(p.size()), b(p.size());

    convolution.apply<1, 1>({{{&of_zz}}}, {p}, {a});
    expect_equal(a, grid.direct_sum(zz, p, false));

    convolution.apply<2, 2>({{{&of_xx, &of_xy}, {&of_xy, &of_yy}}}, {t_x, t_y}, {a, b});
    expect_equal(a, sum(grid.direct_sum(xx, t_x, false), 1, grid.direct_sum(xy, t_y, true)));
    expect_equal(b, sum(grid.direct_sum(xy, t_x, false), 1, grid.direct_sum(yy, t_y, true)));
    for (int i = 0; i < grid.n_x; ++i)
        EXPECT_EQ(b[i], 0) << "the odd part in the plane of symmetry";

    convolution.apply<2, 1, GridConvolution::Phase::forward>({{{&of_xz}, {&of_yz}}}, {p}, {a, b});
    expect_equal(a, grid.direct_sum(xz, p, false));
    expect_equal(b, grid.direct_sum(yz, p, false));

    convolution.apply<1, 2, GridConvolution::Phase::backward>({{{&of_xz, &of_yz}}}, {t_x, t_y},
                                                              {a});
    expect_equal(a, sum(Field(p.size()), -1,
                        sum(grid.direct_sum(xz, t_x, false), 1, grid.direct_sum(yz, t_y, true))));
}

TEST(MirroredConvolution, EqualsTheDirectSum) {
    for (const auto& [n_x, n_y] :
         {std::pair{5, 7}, {12, 9}, {8, 8}, {1, 1}, {1, 13}, {17, 1}, {20, 3}, {11, 4}})
        for (const bool tight : {true, false}) compare({n_x, n_y}, tight);
}

TEST(MirroredConvolution, ThreadsChangeNothing) {
    const int n_x = 37, n_y = 30;
    const Grid grid{n_x, n_y};
    const Field t_x = grid.field(.3, false), t_y = grid.field(.9, true);
    std::vector<Field> results;
    for (const int n_threads : {1, 3}) {
        const MirroredConvolution convolution(n_x, n_y, 80, 120, n_threads);
        const auto of_xx = xx.symbol(convolution), of_xy = xy.symbol(convolution);
        Field a(t_x.size()), b(t_x.size());
        convolution.apply<2, 2>({{{&of_xx, &of_xy}, {&of_xy, &of_xx}}}, {t_x, t_y}, {a, b});
        results.push_back(a);
        results.push_back(b);
    }
    EXPECT_EQ(results[0], results[2]);
    EXPECT_EQ(results[1], results[3]);
}

}  // namespace
}  // namespace tricontact::mirrored_convolution_test

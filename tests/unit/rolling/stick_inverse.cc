// The preconditioner of steady rolling.

#include "rolling/stick_inverse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "rolling/run.h"
#include "tests/unit/rolling/problems.h"

namespace tricontact::stick_inverse_test {
namespace {

using Complex = std::complex<double>;
using Matrix = rolling::RowFactors::Matrix;
using rolling_test::Rig;

/// The compliance of a half-space at k_y = 1 of this nu, with the creep of a relaxing body in front
/// of it (a sum over n >= 0), sampled so that it is smooth over all wave numbers.
std::vector<Matrix> symbol(int n, double nu, double creep) {
    std::vector<Matrix> all(n);
    for (int m = 0; m < n; ++m) {
        const double angle = 2 * std::numbers::pi * m / n, x = 2 * std::sin(angle / 2), y = .8;
        const double odd = std::sin(angle), k2 = x * x + y * y, k = std::sqrt(k2);
        const Complex way = 1. + creep / (1. - .6 * std::exp(Complex(0, -angle)));
        all[m] = {way / k * (1 - nu * x * x / k2), -way * nu * odd * y / (2 * k2 * k),
                  -way * nu * odd * y / (2 * k2 * k), way / k * (1 - nu * y * y / k2)};
    }
    return all;
}

/// Largest Fourier coefficient of the entries at n > 0 (`behind`) or n < 0, over that at n = 0.
double part_at(const std::vector<Matrix>& f, bool behind) {
    const int n = static_cast<int>(f.size());
    double most = 0, at_zero = 0;
    for (int e = 0; e < 4; ++e)
        for (int i = 0; i < n; ++i) {
            Complex sum = 0;
            for (int m = 0; m < n; ++m)
                sum += f[m][e] * std::exp(Complex(0, 2 * std::numbers::pi * m * i / n));
            if (i == 0) at_zero = std::max(at_zero, std::abs(sum));
            if (i > 0 && (2 * i < n) == behind) most = std::max(most, std::abs(sum));
        }
    return most / at_zero;
}

// The product of the factors is the symbol, and each reads one side alone: to rounding and what 64
// waves wrap around (.05 per cell by exp(-.8)).
TEST(StickInverse, FactorsReadOneSide) {
    for (const double creep : {0., .7}) {
        const std::vector<Matrix> s = symbol(64, .5, creep);
        const rolling::RowFactors factors = rolling::factorised(s);
        for (std::size_t m = 0; m < s.size(); ++m) {
            const Matrix &b = factors.behind[m], &a = factors.ahead[m];
            for (int e = 0; e < 4; ++e) {
                const int row = e / 2 * 2, column = e % 2;
                const Complex product = b[row] * a[column] + b[row + 1] * a[column + 2];
                EXPECT_NEAR(std::abs(product - s[m][e]), 0, 1e-6 * std::abs(s[m][0]));
            }
        }
        EXPECT_LT(part_at(factors.behind, false), 1e-6);
        EXPECT_LT(part_at(factors.ahead, true), 1e-6);
        EXPECT_GT(part_at(factors.behind, true), .1);
    }
}

/// Products of a sphere's steady state on n cells in a.
int products(int n, bool spins) {
    const Rig ball{.substrate = {3e6, .3}, .n = n};
    rolling::RollingProblem problem = ball.sphere(0);
    problem.tolerance = 1e-7;
    problem.coupling = false;
    problem.drive.creepage = {spins ? 0 : .7 * ball.creepage(), 0};
    problem.drive.spin = spins ? .5 * ball.creepage() / ball.half_length : 0;
    const auto found = rolling::steady_rolling(*ball.sphere_grid(), problem);
    EXPECT_TRUE(found.audit.passed());
    return found.state.iterations;
}

// With cells by themselves as the preconditioner 183 and 485, with spin 322 and 1250 products.
TEST(StickInverse, ProductsHardlyGrowWithTheGrid) {
    for (const bool spins : {false, true}) {
        const int coarse = products(15, spins), fine = products(45, spins);
        EXPECT_LT(fine, 2.5 * coarse);
        EXPECT_LT(fine, 260);
    }
}

}  // namespace
}  // namespace tricontact::stick_inverse_test

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "contact/compliances/cholesky.h"
#include "contact/compliances/dense_products.h"

namespace tricontact::dense_algebra_test {
namespace {

using contact::Cholesky;

// Around a vector, a group of columns and a panel of the factorisation, and far beyond them.
constexpr std::array sizes = {1, 5, 8, 17, 64, 71, 130, 203};

double uniform(std::mt19937& random) {
    return static_cast<double>(random()) / 4294967296.0 - .5;
}

Eigen::VectorXd numbers(int n, unsigned seed) {
    std::mt19937 random(seed);
    return Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(random); });
}

/// Symmetric, eigenvalues from 1 to about 1 + n / 12.
Eigen::MatrixXd definite_matrix(int n) {
    std::mt19937 random(7u);
    const Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return uniform(random); });
    return Eigen::MatrixXd::Identity(n, n) + a * a.transpose();
}

std::span<double> view(Eigen::VectorXd& v) {
    return {v.data(), static_cast<std::size_t>(v.size())};
}
std::span<const double> view(const Eigen::VectorXd& v) {
    return {v.data(), static_cast<std::size_t>(v.size())};
}

template <class Real>
bool extend(Cholesky<Real>& cholesky, const Eigen::MatrixXd& a, std::size_t n) {
    return cholesky.extend(n, [&](std::size_t i, std::size_t j) { return a(i, j); });
}

TEST(DenseAlgebra, CholeskySolvesLikeEigen) {
    for (const int n : sizes) {
        const Eigen::MatrixXd a = definite_matrix(n);
        const Eigen::VectorXd b = numbers(n, 3u), expected = a.llt().solve(b);
        Cholesky<double> twice;
        Cholesky<float> once;
        ASSERT_TRUE(extend(twice, a, n) && extend(once, a, n));
        Eigen::VectorXd x = b;
        twice.solve(view(x));
        EXPECT_LT((x - expected).norm(), 1e-14 * n * expected.norm()) << n;  // rounding
        std::vector<float> y(b.begin(), b.end());
        once.solve(y);
        const Eigen::VectorXd z = Eigen::Map<Eigen::VectorXf>(y.data(), n).cast<double>();
        EXPECT_LT((z - expected).norm(), 1e-6 * n * expected.norm()) << n;
    }
}

// In whatever steps it grows, and whatever was in its memory before.
TEST(DenseAlgebra, CholeskyGrowsToTheSameBits) {
    for (const int n : sizes) {
        const Eigen::MatrixXd a = definite_matrix(n);
        Cholesky<double> whole, grown;
        ASSERT_TRUE(extend(whole, a, n));
        ASSERT_TRUE(extend(grown, definite_matrix(250), 250));
        grown.clear();
        for (int k = std::min(n, 3); k < n; k += 1 + k / 3) ASSERT_TRUE(extend(grown, a, k));
        ASSERT_TRUE(extend(grown, a, n));
        Eigen::VectorXd x = numbers(n, 5u), y = x;
        whole.solve(view(x));
        grown.solve(view(y));
        EXPECT_EQ(x, y) << n;
    }
}

TEST(DenseAlgebra, CholeskyRefusesAnIndefiniteMatrix) {
    for (const int n : sizes) {
        Eigen::MatrixXd a = definite_matrix(n);
        a(n - 1, n - 1) = -1;
        Cholesky<double> cholesky;
        EXPECT_FALSE(extend(cholesky, a, n)) << n;
        a(n - 1, n - 1) = std::nan("");
        cholesky.clear();
        EXPECT_FALSE(extend(cholesky, a, n)) << n;
    }
}

TEST(DenseAlgebra, ProductsLikeEigens) {
    for (const int n : sizes) {
        Eigen::MatrixXd a = definite_matrix(n);
        const Eigen::VectorXd x = numbers(n, 3u);
        const double rounding = 1e-15 * n * a.norm() * x.norm();
        Eigen::VectorXd sum = numbers(n, 4u), factor = x;
        factor[n / 2] = 0;
        const Eigen::VectorXd expected_sum = sum + a * factor;
        const contact::ColumnBlock<double> columns = {a.data(), static_cast<std::size_t>(n)};
        contact::add_columns(columns, view(std::as_const(factor)), view(sum));
        EXPECT_LT((sum - expected_sum).norm(), rounding) << n;

        const Eigen::VectorXd expected = a * x;
        Eigen::VectorXd y(n);
        contact::multiply_transposed(columns, view(x), view(y));
        EXPECT_LT((y - expected).norm(), rounding) << n;

        // What is above the groups' own triangles is not read.
        for (int l = 0; l < n; ++l)
            for (int k = 0; k < static_cast<int>(contact::first_of_group(l)); ++k)
                a(k, l) = std::nan("");
        contact::multiply_symmetric(columns, view(x), view(y));
        EXPECT_LT((y - expected).norm(), rounding) << n;
        const Eigen::MatrixXf single = a.cast<float>();
        const Eigen::VectorXf x_single = x.cast<float>();
        Eigen::VectorXf y_single(n);
        const auto size = static_cast<std::size_t>(n);
        contact::multiply_symmetric(contact::ColumnBlock<float>{single.data(), size},
                                    std::span(x_single.data(), size),
                                    std::span(y_single.data(), size));
        EXPECT_LT((y_single.cast<double>() - expected).norm(), 1e9 * rounding) << n;
    }
}

}  // namespace
}  // namespace tricontact::dense_algebra_test

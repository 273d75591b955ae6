#include "statistics/growing_least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

#include "statistics/latin_hypercube.h"
#include "statistics/regression.h"

namespace tricontact::statistics::growing_least_squares_test {
namespace {

struct Problem {
    std::vector<std::vector<double>> columns;
    std::vector<double> values;
};

Problem drawn(std::size_t n_values, std::size_t n_columns) {
    SplitMix64 random(11);
    Problem p;
    for (std::size_t k = 0; k < n_columns; ++k)
        for (auto& column = p.columns.emplace_back(); column.size() < n_values;)
            column.push_back(random.uniform() - 0.3);
    while (p.values.size() < n_values) p.values.push_back(random.uniform());
    return p;
}

GrowingLeastSquares grown(const Problem& p) {
    GrowingLeastSquares squares(p.values);
    for (const auto& column : p.columns) EXPECT_TRUE(squares.append(column));
    return squares;
}

TEST(GrowingLeastSquares, GivesTheCoefficientsOfAnyNumberOfColumns) {
    const Problem p = drawn(30, 5);
    const GrowingLeastSquares squares = grown(p);
    for (std::size_t n = 1; n <= 5; ++n) {
        const Fit fit =
            fit_linear({p.columns.begin(), p.columns.begin() + static_cast<int>(n)}, p.values);
        const auto c = squares.coefficients(n);
        ASSERT_EQ(c.size(), n);
        for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(c[k], fit.parameters[k].value, 1e-12);
    }
    const Fit fit = fit_linear(p.columns, p.values);
    double trace = 0;
    for (std::size_t k = 0; k < 5; ++k)
        trace += fit.covariance[k][k] / std::pow(fit.residual_standard_deviation, 2);
    EXPECT_NEAR(squares.inverse_trace() / trace, 1, 1e-12);
    for (std::size_t i = 0; i < 30; ++i)
        EXPECT_NEAR(squares.residuals()[i], fit.residuals[i], 1e-13);
}

// What r/(1 - h) claims to be.
TEST(GrowingLeastSquares, LeavesOneOutAsAFitWithoutIt) {
    const Problem p = drawn(20, 4);
    const GrowingLeastSquares squares = grown(p);
    for (const std::size_t n : {2U, 4U}) {
        const auto left_out = squares.leave_one_out_residuals(n);
        double mean_square = 0;
        for (std::size_t i = 0; i < 20; ++i) {
            std::vector<std::vector<double>> columns(p.columns.begin(),
                                                     p.columns.begin() + static_cast<int>(n));
            std::vector<double> values = p.values;
            for (auto& column : columns) column.erase(column.begin() + static_cast<int>(i));
            values.erase(values.begin() + static_cast<int>(i));
            const Fit fit = fit_linear(columns, values);
            double residual = p.values[i];
            for (std::size_t k = 0; k < n; ++k)
                residual -= fit.parameters[k].value * p.columns[k][i];
            EXPECT_NEAR(left_out[i], residual, 1e-12);
            mean_square += residual * residual / 20;
        }
        if (n == squares.n_columns()) {
            EXPECT_NEAR(squares.leave_one_out_square() / mean_square, 1, 1e-11);
        }
    }
}

TEST(GrowingLeastSquares, RefusesDependentColumns) {
    const Problem p = drawn(6, 3);
    GrowingLeastSquares squares = grown(p);
    std::vector<double> sum(6);
    for (std::size_t i = 0; i < 6; ++i) sum[i] = p.columns[0][i] - 2 * p.columns[2][i];
    EXPECT_FALSE(squares.append(sum));
    EXPECT_FALSE(squares.append(std::vector<double>(6, 0.)));
    EXPECT_EQ(squares.n_columns(), 3U);
}

// Powers of x, whose columns are almost dependent: orthogonal to rounding, so a polynomial comes
// back as far as its condition number of 1e9 allows.
TEST(GrowingLeastSquares, KeepsItsDigitsWhereColumnsAreAlmostDependent) {
    constexpr std::size_t n = 60, n_powers = 12;
    std::vector<double> values(n, 0.);
    std::vector<std::vector<double>> columns(n_powers, std::vector<double>(n));
    for (std::size_t k = 0; k < n_powers; ++k)
        for (std::size_t i = 0; i < n; ++i) {
            columns[k][i] = std::pow(static_cast<double>(i) / n, static_cast<double>(k));
            values[i] += columns[k][i];
        }
    GrowingLeastSquares squares(values);
    for (const auto& column : columns) EXPECT_TRUE(squares.append(column));
    for (const double c : squares.coefficients(n_powers)) EXPECT_NEAR(c, 1, 1e-6);
    for (const double r : squares.residuals()) EXPECT_NEAR(r, 0, 1e-13);
}

// A column that one value alone determines.
TEST(GrowingLeastSquares, ErrorWithoutAValueThatACoefficientNeedsIsInfinite) {
    GrowingLeastSquares squares({1, 2, 3});
    EXPECT_TRUE(squares.append(std::vector{1., 1., 1.}));
    EXPECT_TRUE(squares.append(std::vector{0., 0., 1.}));
    EXPECT_TRUE(std::isinf(squares.leave_one_out_square()));
}

}  // namespace
}  // namespace tricontact::statistics::growing_least_squares_test

#include "statistics/residual_correlation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "tests/unit/statistics/autoregressive.h"

namespace tricontact::statistics::residual_correlation_test {
namespace {

std::vector<std::size_t> rows_up_to(std::size_t n) {
    std::vector<std::size_t> rows(n);
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

/// Constant and straight line.
std::vector<std::vector<double>> line(std::size_t n) {
    std::vector<std::vector<double>> columns(2, std::vector<double>(n, 1.));
    std::iota(columns[1].begin(), columns[1].end(), 1.);
    return columns;
}

/// What least squares leave of errors beside these columns.
std::vector<double> left_of(std::vector<double> errors, const ResidualProjection& projection) {
    for (const auto& q : projection.basis()) {
        const double part = std::inner_product(q.begin(), q.end(), errors.begin(), 0.);
        for (std::size_t i = 0; i < errors.size(); ++i) errors[i] -= part * q[i];
    }
    return errors;
}

TEST(ResidualCorrelation, ProductsAreTheDoubleSum) {
    const std::vector<double> x{1, -2, .5, 3}, y{.3, 2, -1, .7};
    double sum = 0;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) sum += x[i] * std::pow(.6, std::abs(i - k)) * y[k];
    EXPECT_NEAR(correlated_product(x, y, .6), sum, 1e-14);
}

// The variance of a mean of an autoregressive series in closed form (Box, Jenkins and Reinsel
// 1994): what a fitted constant takes off the sum of squares.
TEST(ResidualCorrelation, AFittedConstantTakesTheVarianceOfTheMean) {
    constexpr int n = 12;
    const ResidualProjection constant({std::vector<double>(n, 3.)});
    for (const double rho : {0., .4, .9}) {
        const double of_mean =
            ((1 + rho) / (1 - rho) - 2 * rho * (1 - std::pow(rho, n)) / std::pow(1 - rho, 2) / n);
        EXPECT_NEAR(mean_sum_of_squares(rows_up_to(n), constant, rho), n - of_mean, 1e-12) << rho;
    }
}

// Chances of what is due to chance are uniform: 5 of 100 are below 5 %. Three standard deviations
// of 300 samples; fourteen rows beside three columns, as tables have.
TEST(ResidualCorrelationSlow, IndependentErrorsAreFoundCorrelatedAsOftenAsStated) {
    constexpr std::size_t n = 14;
    auto columns = line(n);
    columns.emplace_back();
    for (std::size_t i = 0; i < n; ++i) columns[2].push_back(std::exp(-.4 * double(i)));
    const ResidualProjection projection(columns);
    std::mt19937_64 generator(1);
    constexpr int n_samples = 300;
    int n_below = 0;
    for (int k = 0; k < n_samples; ++k) {
        const auto errors = autoregressive(0, n, generator);
        const auto found =
            residual_correlation(left_of(errors, projection), rows_up_to(n), projection);
        n_below += found.chance < .05;
    }
    EXPECT_NEAR(n_below / double(n_samples), .05, 3 * std::sqrt(.05 * .95 / n_samples) + .007);
}

// Of long series rho is estimated to sqrt((1 - rho^2)/n) (Bartlett); not excluded are values up to
// 1.64 of that above it, in the mean of samples. Estimates that come from fewer rows are right in
// the mean as well, which those from residuals alone are not: -1/n and less of independent errors.
TEST(ResidualCorrelationSlow, OfAutoregressiveErrorsIsTheirs) {
    constexpr std::size_t n = 300;
    const ResidualProjection projection(line(n));
    std::mt19937_64 generator(2);
    for (const double rho : {.3, .7}) {
        constexpr int n_samples = 10;
        double mean = 0, bound = 0;
        for (int k = 0; k < n_samples; ++k) {
            const auto errors = autoregressive(rho, n, generator);
            const auto found =
                residual_correlation(left_of(errors, projection), rows_up_to(n), projection);
            mean += found.of_errors / n_samples;
            bound += found.not_excluded / n_samples;
            EXPECT_LT(found.chance, .01);
        }
        const double error = std::sqrt((1 - rho * rho) / n);
        EXPECT_NEAR(mean, rho, 3 * error / std::sqrt(n_samples)) << rho;
        EXPECT_NEAR(bound, rho + 1.64 * error, error) << rho;
    }
}

// A parameter at its bound moves no value: residuals are the errors themselves, of which the
// lag-one product has the mean 0 and the variance 1/n (Bartlett).
TEST(ResidualCorrelation, OfNothingFittedIsThatOfTheErrors) {
    constexpr std::size_t n = 300;
    const ResidualProjection projection({std::vector<double>(n, 0.)});
    ASSERT_TRUE(projection.basis().empty());
    std::mt19937_64 generator(4);
    const auto correlated = autoregressive(.7, n, generator);
    const auto found = residual_correlation(correlated, rows_up_to(n), projection);
    EXPECT_NEAR(found.of_errors, .7, 3 * std::sqrt((1 - .7 * .7) / n));
    EXPECT_LT(found.chance, .01);
    const auto independent =
        residual_correlation(autoregressive(0, n, generator), rows_up_to(n), projection);
    EXPECT_NEAR(independent.lag_one, 0, 3 / std::sqrt(n));
    EXPECT_GT(independent.chance, .001);
}

// A few rows that others are joined with: nothing is told of these.
TEST(ResidualCorrelation, SeesTheRowsOfOneTableAlone) {
    constexpr std::size_t n = 200;
    const auto columns = line(2 * n);
    const ResidualProjection projection(columns);
    std::mt19937_64 generator(3);
    auto errors = autoregressive(.8, n, generator);
    const auto others = autoregressive(0, n, generator);
    errors.insert(errors.end(), others.begin(), others.end());
    const auto residuals = left_of(errors, projection);
    std::vector<std::size_t> second = rows_up_to(n);
    for (std::size_t& row : second) row += n;
    EXPECT_NEAR(residual_correlation(residuals, rows_up_to(n), projection).of_errors, .8, .13);
    EXPECT_GT(residual_correlation(residuals, second, projection).chance, .01);
}

}  // namespace
}  // namespace tricontact::statistics::residual_correlation_test

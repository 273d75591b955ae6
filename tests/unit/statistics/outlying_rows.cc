#include "statistics/outlying_rows.h"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace tricontact::statistics::outlying_rows_test {
namespace {

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

/// Residuals of a fitted mean over an error, and their slopes.
struct MeanFit {
    std::vector<double> residuals;
    std::vector<std::vector<double>> columns;

    MeanFit(const std::vector<double>& values, double error) {
        const double mean = mean_of(values);
        for (const double value : values) residuals.push_back((value - mean) / error);
        columns.assign(1, std::vector<double>(values.size(), -1 / error));
    }
};

double standard_deviation(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values) squares += std::pow(value - mean_of(values), 2);
    return std::sqrt(squares / double(values.size() - 1));
}

// One value beside the mean of the others: Student's t of a new value, in closed form.
TEST(OutlyingRows, OfAMeanIsStudentsPrediction) {
    const std::vector<double> values{1.1, .9, 1.05, 7, .95, 1.2, .8};
    const std::vector<double> others{1.1, .9, 1.05, .95, 1.2, .8};
    const MeanFit fit(values, standard_deviation(values));
    const auto rows =
        outlying_rows(fit.residuals, fit.columns, {{.n_rows = 7, .is_known = false}}, .01);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].row, 3u);
    const double s = standard_deviation(others), t = (7 - mean_of(others)) / s / std::sqrt(7. / 6);
    EXPECT_NEAR(rows[0].deviation, t, 1e-9);
    EXPECT_NEAR(rows[0].chance, 7 * 2 * gsl_cdf_tdist_Q(t, 5), 1e-12);
    EXPECT_NEAR(rows[0].change[0], mean_of(others) - mean_of(values), 1e-12);
}

// Of stated errors it is normal; a second one is found without the first, which hides it.
TEST(OutlyingRows, OfStatedErrorsAreNormal) {
    std::vector<double> values{0, .1, -.1, .05, -.05, 0, 6, .1, -.1, -5};
    const MeanFit fit(values, 1.);
    const auto rows = outlying_rows(fit.residuals, fit.columns, {{.n_rows = 10}}, .01);
    ASSERT_EQ(rows.size(), 2u);
    const double share = 1 - 1. / 10;
    EXPECT_NEAR(rows[0].deviation, (6 - mean_of(values)) / std::sqrt(share), 1e-9);
    EXPECT_NEAR(rows[0].chance, 10 * 2 * gsl_cdf_ugaussian_Q(rows[0].deviation), 1e-12);
    values.erase(values.begin() + 6);
    EXPECT_NEAR(rows[1].deviation, (-5 - mean_of(values)) / std::sqrt(1 - 1. / 9), 1e-9);
    EXPECT_EQ(rows[1].row, 9u);
}

// Bonferroni's inequality is nearly an equality for so rare events: at 5 % in 4.5 to 5 % of
// samples.
TEST(OutlyingRows, AreAsRareAsStated) {
    std::mt19937_64 generator(4);
    std::normal_distribution<double> gauss;
    constexpr int n_samples = 2000;
    for (const bool is_known : {true, false}) {
        int n_found = 0;
        for (int k = 0; k < n_samples; ++k) {
            std::vector<double> values(12);
            for (double& value : values) value = gauss(generator);
            const MeanFit fit(values, is_known ? 1. : standard_deviation(values));
            n_found += !outlying_rows(fit.residuals, fit.columns,
                                      {{.n_rows = 12, .is_known = is_known}}, .05)
                            .empty();
        }
        EXPECT_NEAR(n_found / double(n_samples), .049, 3 * std::sqrt(.05 * .95 / n_samples));
    }
}

// Rows of another table hold the mean at 0: the scatter is that of the other rows about 0, and what
// the row would move the mean by, were it alone, is not taken off it.
TEST(OutlyingRows, OfATableWhoseMeanAnotherOneHolds) {
    const std::vector<double> values{.1, -.1, .1, -.1, .05, 1};
    const double error = std::sqrt((4 * .01 + .0025 + 1) / 6);
    std::vector<double> residuals, column;
    for (const double value : values) {
        residuals.push_back(value / error);
        column.push_back(-1 / error);
    }
    for (int i = 0; i < 10; ++i) {
        residuals.push_back(0);
        column.push_back(-1e3);
    }
    const auto rows =
        outlying_rows(residuals, {column}, {{.n_rows = 6, .is_known = false}, {.n_rows = 10}}, .05);
    ASSERT_EQ(rows.size(), 1u);
    // The mean is 1e-6 off 0.
    EXPECT_NEAR(rows[0].deviation, 1 / std::sqrt((4 * .01 + .0025) / 5), 1e-3);
}

// Exact values have rounding for residuals: no row of these is an outlier.
TEST(OutlyingRows, FitsToRoundingHaveNone) {
    const std::vector<double> values{1, 1, 1, 1 + 1e-15, 1, 1};
    const MeanFit fit(values, 1e-12);
    EXPECT_TRUE(
        outlying_rows(fit.residuals, fit.columns, {{.n_rows = 6, .is_known = false}}, .01).empty());
}

}  // namespace
}  // namespace tricontact::statistics::outlying_rows_test

#include "statistics/regression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "contact/base/error.h"

namespace tricontact::statistics::regression_test {
namespace {

// Statistical Reference Datasets of NIST (www.itl.nist.gov/div898/strd); certified values.
const std::vector<double> norris_y{.1,    338.8, 118.1, 888.0, 9.2,   228.1, 668.5, 998.5, 449.1,
                                   778.9, 559.2, .3,    .1,    778.1, 668.8, 339.3, 448.9, 10.8,
                                   557.7, 228.3, 998.0, 888.8, 119.6, .3,    .6,    557.6, 339.3,
                                   888.0, 998.5, 778.9, 10.2,  117.6, 228.9, 668.4, 449.2, .2};
const std::vector<double> norris_x{.2,    337.4, 118.2, 884.6, 10.1,  226.5, 666.3, 996.3, 448.6,
                                   777.0, 558.2, .4,    .6,    775.5, 666.9, 338.0, 447.5, 11.6,
                                   556.0, 228.1, 995.8, 887.6, 120.2, .3,    .3,    556.8, 339.1,
                                   887.2, 999.0, 779.0, 11.1,  118.3, 229.2, 669.1, 448.9, .5};

// The certified values have 15 digits; least squares in double keep 12 of them here.
void expect_certified(double value, double certified) {
    EXPECT_NEAR(value / certified, 1, 1e-11);
}

TEST(Regression, LineIsNistsNorris) {
    const Fit fit = fit_linear({std::vector<double>(36, 1.), norris_x}, norris_y);
    expect_certified(fit.parameters[0].value, -0.262323073774029);
    expect_certified(fit.parameters[0].standard_error, 0.232818234301152);
    expect_certified(fit.parameters[1].value, 1.00211681802045);
    expect_certified(fit.parameters[1].standard_error, 0.429796848199937e-3);
    expect_certified(fit.residual_standard_deviation, 0.884796396144373);
    expect_certified(fit.r_squared(), 0.999993745883712);
}

TEST(Regression, LineThroughOriginIsNistsNoInt1) {
    std::vector<double> x(11), y(11);
    std::iota(x.begin(), x.end(), 60.);
    std::iota(y.begin(), y.end(), 130.);
    const Fit fit = fit_linear({x}, y);
    expect_certified(fit.parameters[0].value, 2.07438016528926);
    expect_certified(fit.parameters[0].standard_error, 0.165289256198347e-1);
    expect_certified(fit.residual_standard_deviation, 3.56753034006338);
    expect_certified(fit.r_squared(), 0.999365492298663);
}

TEST(Regression, CurveIsNistsMisra1a) {
    const std::vector<double> x{77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                                378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
    const std::vector<double> y{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                                44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};
    const FitModel model = [&](const std::vector<double>& b) {
        std::vector<double> out;
        for (const double v : x) out.push_back(b[0] * (1 - std::exp(-b[1] * v)));
        return out;
    };
    for (const auto& start : {std::vector<double>{500, 1e-4}, std::vector<double>{250, 5e-4}}) {
        const Fit fit = fit_nonlinear(model, y, start);
        // Eleven certified digits; the differences for the derivatives cost errors some of them.
        EXPECT_NEAR(fit.parameters[0].value / 2.3894212918e2, 1, 1e-8);
        EXPECT_NEAR(fit.parameters[1].value / 5.5015643181e-4, 1, 1e-8);
        EXPECT_NEAR(fit.parameters[0].standard_error / 2.7070075241, 1, 1e-6);
        EXPECT_NEAR(fit.parameters[1].standard_error / 7.2668688436e-6, 1, 1e-6);
        EXPECT_NEAR(fit.residual_sum_of_squares / 1.2455138894e-1, 1, 1e-9);
    }
}

// A mean of two readings whose errors are .5 each.
TEST(Regression, KnownErrorsAreNotEstimated) {
    const Fit fit = fit_linear({{1, 1}}, {2, 4}, {.weights = {4, 4}, .weights_are_absolute = true});
    EXPECT_NEAR(fit.parameters[0].standard_error, .5 / std::sqrt(2), 1e-14);
    EXPECT_NEAR(fit.parameters[0].high - 3, 1.959963984540054 * .5 / std::sqrt(2), 1e-14);
}

TEST(Regression, StartsAtTheLeastSquaresToo) {
    const FitModel model = [](const std::vector<double>& p) {
        return std::vector<double>{p[0], p[0], p[0]};
    };
    EXPECT_NEAR(fit_nonlinear(model, {1, 2, 3}, {2}).parameters[0].value, 2, 1e-12);
}

// Tables of Student's distribution: two-sided 95 %, and DIN 1319-3's 68.26 % for five readings.
TEST(Regression, StudentsFactors) {
    EXPECT_NEAR(student_t(.95, 1), 12.706, 5e-4);
    EXPECT_NEAR(student_t(.95, 10), 2.228, 5e-4);
    EXPECT_NEAR(student_t(.6826, 4), 1.14, 5e-3);
}

// 2000 samples: the share that covers the truth scatters by sqrt(.95 .05/2000) = .005; four of
// them.
TEST(Regression, IntervalsCoverTheTruthAsOftenAsTheyClaim) {
    std::mt19937_64 random(20161121);
    std::normal_distribution<double> noise(0, .3);
    const std::vector<double> x{.5, 1, 2, 3, 5};
    int covered = 0;
    for (int sample = 0; sample < 2000; ++sample) {
        std::vector<double> y;
        for (const double v : x) y.push_back(1.7 * v + noise(random));
        const Estimate slope = fit_linear({x}, y).parameters[0];
        covered += slope.low <= 1.7 && 1.7 <= slope.high;
    }
    EXPECT_NEAR(covered / 2000., .95, .02);
}

TEST(Regression, WeightsRepeatAnObservation) {
    const std::vector<double> x{1, 2, 4}, y{1.1, 1.7, 4.3};
    const Fit weighted = fit_linear({x}, y, {.weights = {1, 1, 2}});
    const Fit repeated = fit_linear({{1, 2, 4, 4}}, {1.1, 1.7, 4.3, 4.3});
    EXPECT_NEAR(weighted.parameters[0].value, repeated.parameters[0].value, 1e-14);
    EXPECT_NEAR(weighted.residual_sum_of_squares, repeated.residual_sum_of_squares, 1e-14);
}

TEST(Regression, RefusesWhatDeterminesNothing) {
    EXPECT_THROW(fit_linear({{1}}, {1}), std::invalid_argument);
    EXPECT_THROW(fit_linear({{1, 2, 3}, {2, 4, 6}}, {1, 2, 4}), contact::NotConverged);
    EXPECT_THROW(fit_linear({{0, 0, 0}}, {1, 2, 4}), contact::NotConverged);
}

}  // namespace
}  // namespace tricontact::statistics::regression_test

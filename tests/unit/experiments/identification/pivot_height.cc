// Shifts that follow the drive: a line through points, whose slope and its error are those of
// linear regression.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "experiments/identification/estimation/identification.h"
#include "experiments/identification/estimation/told_combination.h"
#include "experiments/identification/identification_reader.h"
#include "statistics/estimate.h"

namespace tricontact::experiments::pivot_height_test {
namespace {

using Values = std::vector<double>;

constexpr double radius = 40e-3, height = -62e-6;
const Values offsets{-1e-3, -.6e-3, -.2e-3, .3e-3, .7e-3, 1e-3, .5e-3, 0};
// Any numbers, of about 0.2 um.
const Values noise{.1e-6, -.3e-6, .2e-6, .25e-6, -.15e-6, -.2e-6, .05e-6, .3e-6};

FreeParameter pivot() {
    FreeParameter p{.key = std::string(pivot_key),
                    .name = "pivot_height_m",
                    .symbol = "Dh",
                    .unit = "m",
                    .scale = FreeParameter::Scale::either_sign,
                    .size = 50e-6};
    p.high = 1e3 * p.size;
    p.low = -p.high;
    return p;
}

Values shifts(double dh, double r) {
    Values values;
    for (const double w : offsets) values.push_back(w * dh / r);
    return values;
}

IdentificationTask task(double origin) {
    IdentificationTask t;
    t.parameters = {pivot()};
    t.tables = {
        {.name = "rolling-shift", .observed = shifts(height, radius), .has_free_origin = true}};
    for (std::size_t i = 0; i < noise.size(); ++i) t.tables[0].observed[i] += origin + noise[i];
    t.model = [](const Values& v) { return shifts(v[0], radius); };
    return t;
}

/// Slope, its standard error, and the intercept, of the textbooks.
struct Line {
    double slope = 0, error = 0, intercept = 0;
};
Line regression(const Values& y) {
    const auto n = double(y.size());
    const auto sum = [](const Values& v) { return std::accumulate(v.begin(), v.end(), 0.); };
    const double x_mean = sum(offsets) / n, y_mean = sum(y) / n;
    double xx = 0, xy = 0, rest = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        xx += (offsets[i] - x_mean) * (offsets[i] - x_mean);
        xy += (offsets[i] - x_mean) * (y[i] - y_mean);
    }
    Line line{.slope = xy / xx};
    line.intercept = y_mean - line.slope * x_mean;
    for (std::size_t i = 0; i < y.size(); ++i)
        rest += std::pow(y[i] - line.intercept - line.slope * offsets[i], 2);
    line.error = std::sqrt(rest / (n - 2) / xx);
    return line;
}

TEST(PivotHeight, IsTheSlopeOfARegressionLineWhereverItIsCountedFrom) {
    for (const double origin : {0., 35e-6, -2e-3}) {
        const IdentificationTask t = task(origin);
        const Identification found = identify(t);
        const Line line = regression(t.tables[0].observed);
        const double half = statistics::student_t(.95, int(noise.size()) - 2) * line.error;
        const ParameterEstimate& p = found.parameters[0];
        // Rounding of shifts counted from far away.
        const double tolerance = 1e-6 * radius * line.error + 1e-9 * std::abs(origin);
        EXPECT_NEAR(p.value, radius * line.slope, tolerance);
        EXPECT_NEAR(p.standard_error, radius * line.error, tolerance);
        EXPECT_NEAR(p.likelihood.low, radius * (line.slope - half), 10 * tolerance);
        EXPECT_NEAR(p.likelihood.high, radius * (line.slope + half), 10 * tolerance);
        EXPECT_NEAR(found.tables[0].origin, line.intercept, 1e-9 * std::abs(origin) + 1e-12);
        EXPECT_EQ(found.degrees_of_freedom, int(noise.size()) - 2);
    }
}

TEST(PivotHeight, IsToldOverTheRadiusAlone) {
    IdentificationTask t = task(0);
    t.parameters.push_back({.key = "indenter.radius",
                            .symbol = "R",
                            .unit = "m",
                            .low = radius / 100,
                            .high = radius * 100,
                            .start = radius});
    t.model = [](const Values& v) { return shifts(v[0], v[1]); };
    const Identification found = identify(t);
    const auto told = told_combinations(found);
    ASSERT_EQ(told.size(), 1U);
    ASSERT_EQ(told[0].exponents.size(), 2U);
    EXPECT_NEAR(told[0].exponents[1], -1, 1e-4);
    const Line line = regression(t.tables[0].observed);
    EXPECT_NEAR(told[0].standard_error / std::abs(line.error / line.slope), 1, 1e-3);
}

}  // namespace
}  // namespace tricontact::experiments::pivot_height_test

#include "statistics/error_propagation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace tricontact::statistics::error_propagation_test {
namespace {

// JCGM 100:2008, H.2: resistance, reactance and impedance from five simultaneous readings of
// voltage, current and phase; tables H.2 (means, errors, correlations) and H.3 (results).
const std::vector<Estimate> readings = {
    {4.9990, 0.0032}, {19.6610e-3, 0.0095e-3}, {1.04446, 0.00075}};
const std::vector<std::vector<double>> correlation = {
    {1, -0.36, 0.86}, {-0.36, 1, -0.65}, {0.86, -0.65, 1}};

TEST(ErrorPropagation, EqualsTheExampleOfTheGuideWithCorrelatedQuantities) {
    const auto resistance = propagate([](const auto& x) { return x[0] / x[1] * std::cos(x[2]); },
                                      readings, correlation);
    const auto reactance = propagate([](const auto& x) { return x[0] / x[1] * std::sin(x[2]); },
                                     readings, correlation);
    const auto impedance =
        propagate([](const auto& x) { return x[0] / x[1]; }, readings, correlation);
    // The guide propagated unrounded readings; the errors above have two digits.
    EXPECT_NEAR(resistance.result.value, 127.732, 0.001);
    EXPECT_NEAR(resistance.result.standard_error, 0.071, 0.003);
    EXPECT_NEAR(reactance.result.value, 219.847, 0.001);
    EXPECT_NEAR(reactance.result.standard_error, 0.295, 0.003);
    EXPECT_NEAR(impedance.result.value, 254.260, 0.001);
    EXPECT_NEAR(impedance.result.standard_error, 0.236, 0.003);
}

TEST(ErrorPropagation, RelativeErrorsOfAPowerLawAddInSquares) {
    const std::vector<Estimate> x = {{3e9, 3e7}, {2e-6, 1e-7}, {5, 0}};
    const auto p = propagate([](const auto& v) { return v[0] * std::pow(v[1], -2) * v[2]; }, x);
    const double relative = p.result.standard_error / p.result.value;
    EXPECT_NEAR(relative, std::hypot(0.01, 2 * 0.05), 1e-9);
    EXPECT_NEAR(p.contributions[0] / p.result.value, 0.01, 1e-9);
    EXPECT_NEAR(p.contributions[1] / p.result.value, -0.1, 1e-9);
    EXPECT_EQ(p.contributions[2], 0);
}

TEST(ErrorPropagation, FullyCorrelatedErrorsCancelInADifference) {
    const std::vector<Estimate> x = {{7, 0.5}, {4, 0.5}};
    const auto difference = [](const auto& v) { return v[0] - v[1]; };
    EXPECT_NEAR(propagate(difference, x).result.standard_error, std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(propagate(difference, x, {{1, 1}, {1, 1}}).result.standard_error, 0, 1e-6);
}

TEST(ErrorPropagation, AValueOfZeroHasASlope) {
    const auto p = propagate([](const auto& v) { return std::sin(v[0]); }, {{0, 0.01}});
    EXPECT_NEAR(p.result.standard_error, 0.01, 1e-10);
}

TEST(ErrorPropagation, StaysWithinTheStandardErrors) {
    // As Poisson's ratio near 1/2: the function ends one error away.
    const auto f = [](const auto& v) { return v[0] <= 0.5 ? v[0] * v[0] : std::nan(""); };
    EXPECT_NEAR(propagate(f, {{0.4999, 1e-4}}).result.standard_error, 2 * 0.4999 * 1e-4, 1e-12);
}

TEST(ErrorPropagation, RefusesWhatHasNoMeaning) {
    const auto root = [](const auto& v) { return std::sqrt(v[0]); };
    EXPECT_THROW(propagate(root, {{1, -0.1}}), std::invalid_argument);
    EXPECT_THROW(propagate(root, {{1, std::numeric_limits<double>::quiet_NaN()}}),
                 std::invalid_argument);
    EXPECT_THROW(propagate(root, {{1, 0.1}}, {{1, 0}}), std::invalid_argument);
    EXPECT_THROW(propagate(root, {{-1, 0.1}}), std::domain_error);
    EXPECT_THROW(propagate(root, {{0, 0.1}}), std::domain_error);
}

}  // namespace
}  // namespace tricontact::statistics::error_propagation_test

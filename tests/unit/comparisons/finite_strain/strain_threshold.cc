#include "comparisons/finite_strain/strain_threshold.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tricontact::comparisons::strain_threshold_test {
namespace {

std::vector<DeviationPoint> sampled(const std::function<double(double)>& deviation, double error) {
    std::vector<DeviationPoint> points;
    for (double x = .5; x < 50; x *= 2) points.push_back({x, deviation(x), error});
    return points;
}

TEST(StrainThreshold, OfADeviationProportionalToItsAbscissa) {
    const auto points = sampled([](double x) { return .003 * x; }, 0);
    EXPECT_NEAR(strain_threshold(points, .02, false)->at.value(), .02 / .003, 1e-9);
    EXPECT_TRUE(strain_threshold(points, .001, false)->from_begin);
}

TEST(StrainThreshold, OfADeviationThatGrowsAsStrainsDo) {
    for (const double sign : {1., -1.}) {
        const auto points = sampled([&](double x) { return sign * .003 * std::cbrt(x); }, 0);
        const auto threshold = strain_threshold(points, .006, true);
        ASSERT_TRUE(threshold && threshold->at);
        EXPECT_NEAR(*threshold->at, 8, 1e-8);
        EXPECT_FALSE(threshold->from_begin);
        EXPECT_FALSE(threshold->returns);
        EXPECT_NEAR(*threshold->low, 8, 1e-8);
        EXPECT_NEAR(*threshold->high, 8, 1e-8);
        // Below the first point: between no load, where there is no deviation, and that one.
        EXPECT_NEAR(strain_threshold(points, .001, true)->at.value(), 1 / 27., 1e-9);
    }
}

TEST(StrainThreshold, OfACurvedDeviationToTheInterpolantsAccuracy) {
    const auto points = sampled([](double x) { return .004 * std::pow(x, .45); }, 0);
    // Points lie apart by a factor of 1.26 in the cube root, of which 1.35 is the power.
    const double exact = std::pow(2.5, 1 / .45);
    EXPECT_NEAR(strain_threshold(points, .01, true)->at.value(), exact, .003 * exact);
}

TEST(StrainThreshold, ItsIntervalIsThatOfTheError) {
    const auto points = sampled([](double x) { return .003 * x; }, .002);
    const auto threshold = strain_threshold(points, .02, false);
    EXPECT_NEAR(*threshold->low, .018 / .003, 1e-9);
    EXPECT_NEAR(*threshold->high, .022 / .003, 1e-9);
}

TEST(StrainThreshold, NotReachedAndUnknown) {
    const auto points = sampled([](double x) { return .001 * x; }, .005);
    const auto threshold = strain_threshold(points, .05, true);  // .032 at the last point
    ASSERT_TRUE(threshold);
    EXPECT_FALSE(threshold->at);
    EXPECT_FALSE(threshold->from_begin);
    EXPECT_FALSE(threshold->low);
    // Reached by the error alone.
    const auto open = strain_threshold(points, .035, true);
    EXPECT_FALSE(open->at);
    EXPECT_TRUE(open->low);
    EXPECT_FALSE(strain_threshold({points.begin(), points.begin() + 3}, .001, false));
    EXPECT_TRUE(strain_threshold({points.begin(), points.begin() + 3}, .001, true));
}

TEST(StrainThreshold, SeesThatADeviationFallsAgain) {
    const auto points = sampled([](double x) { return .001 * x * (36 - x) / 10; }, 0);
    const auto threshold = strain_threshold(points, .02, false);
    ASSERT_TRUE(threshold && threshold->at);
    EXPECT_TRUE(threshold->returns);
    EXPECT_NEAR(*threshold->at, 18 - std::sqrt(124), .2);
}

}  // namespace
}  // namespace tricontact::comparisons::strain_threshold_test

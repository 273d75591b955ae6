#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "comparisons/model_differences.h"
#include "comparisons/rolling_points.h"
#include "comparisons_rolling_study.h"

namespace tricontact::comparisons {
namespace {

TEST(NumericalBar, LevelsOfKnownOrder) {
    // v = 2 + 0.3 h^2 exactly: order and limit come back, Roache's index covers the finest value.
    std::vector<double> sizes{1, std::sqrt(0.5), 0.5}, values;
    for (const double h : sizes) values.push_back(2 + 0.3 * h * h);
    const Computed value = value_of_levels(sizes, values);
    EXPECT_NEAR(value.value, 2, 1e-12);
    EXPECT_GE(value.error, values.back() - 2);
    // Two levels of a first-order quantity: the bar covers the truth, the value stays.
    const Computed two = value_of_levels({1, 0.5}, {3, 2.5});
    EXPECT_DOUBLE_EQ(two.value, 2.5);
    EXPECT_GE(two.error, 0.5);
    EXPECT_FALSE(value_of_levels({1}, {3}).has_bar());
}

TEST(NumericalBar, StepsOfFirstOrder) {
    const auto at = [](int n) { return 0.4 - 0.03 / n + 0.02 / (n * n); };
    const Computed two = value_of_steps({6, 12}, {at(6), at(12)});
    EXPECT_NEAR(two.value, 0.4, two.error);
    EXPECT_LT(two.error, 0.03 / 12);
    const Computed three = value_of_steps({6, 12, 24}, {at(6), at(12), at(24)});
    EXPECT_NEAR(three.value, 0.4, three.error);
    EXPECT_FALSE(value_of_steps({6}, {at(6)}).has_bar());
}

TEST(NumericalBar, WhatIsStillToComeOfAGeometricDecay) {
    const double r = 0.8, first = 0.05;
    for (const int n : {2, 12, 60}) {
        const double last = first * std::pow(r, n - 1);
        // Three digits of the ratio are asked for.
        EXPECT_NEAR(
            still_to_come(first * (1 - std::pow(r, n)) / (1 - r), last, n) / (last * r / (1 - r)),
            1, 0.02);
    }
    EXPECT_TRUE(std::isinf(still_to_come(0.5, 0.1, 5)));
    EXPECT_EQ(still_to_come(0.5, 0, 5), 0);
}

TEST(RollingPoints, LevelsAndStepsOfAPointAreOne) {
    std::vector<RollingRun> runs;
    for (const int level : {0, 1})
        for (const int n : {6, 12}) {
            RollingRun run = rolling_run("bem", 0.5, 0.8, "ratcheting");
            run.level = level;
            run.steps_per_quarter = n;
            // First order in the steps and in the cells, both of exact coefficients.
            run.results["shift_increment_ratio"] = 0.5 - 0.06 / n + 0.01 * std::pow(2, -level / 2.);
            runs.push_back(run);
        }
    const auto points = rolling_points(runs);
    ASSERT_EQ(points.size(), 1u);
    ASSERT_TRUE(points[0].increment);
    EXPECT_NEAR(points[0].increment->value, 0.5 + 0.01 * std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(points[0].increment->value, 0.5, points[0].increment->error);
    EXPECT_FALSE(points[0].settled_shift);
}

TEST(RollingPoints, TurningPointsGiveNoShiftPerPeriod) {
    const auto points = rolling_points({rolling_run("mdr", 0.5, 0.8, "ratcheting")});
    EXPECT_EQ(points.at(0).behaviour, Behaviour::ratcheting);
    EXPECT_FALSE(points.at(0).increment);
}

TEST(RollingPoints, UndecidedIsSettledOnlyWhereTheShiftStandsStill) {
    RollingRun to_and_fro = rolling_run("bem-layer", 0.5, 0.2, "undecided");
    to_and_fro.results["shift_increment_ratio"] = 1e-8;
    RollingRun moving = rolling_run("bem-layer", 0.5, 0.3, "undecided");
    moving.results["shift_increment_ratio"] = 2e-5;
    const auto points = rolling_points({to_and_fro, moving});
    EXPECT_TRUE(points.at(0).settled_shift);
    EXPECT_FALSE(points.at(1).settled_shift);
}

TEST(RollingPoints, WhatLiesOutOfRangeIsLeftOut) {
    RollingRun failed = rolling_run("mdr", 0.5, 0.2, "shakedown");
    failed.results["amplitude_ratio"] = nullptr;
    EXPECT_TRUE(rolling_points({failed, rolling_run("mdr", 1.5, 0.2, "shakedown")}).empty());
}

TEST(RollingPoints, Directions) {
    const double right = std::numbers::pi / 2;
    EXPECT_EQ(direction_name(0), "parallel");
    EXPECT_EQ(direction_name(-2 * right), "parallel");
    EXPECT_EQ(direction_name(3 * right), "perpendicular");
    EXPECT_EQ(direction_name(right / 3), "30 deg");
}

TEST(ModelDifferences, OnlyBarsThatExcludeEachOtherTellModelsApart) {
    std::vector<RollingPoint> points;
    const auto add = [&](const char* model, double w, double u, double error) {
        RollingPoint p{.model = model, .group = "parallel", .point = std::to_string(w)};
        p.amplitude_ratio = w;
        p.tangential_ratio = 0.3;
        p.behaviour = Behaviour::settled;
        p.settled_shift = {u, error};
        points.push_back(p);
    };
    add("mdr", 0.2, 0.40, 0.01);
    add("mdr", 0.3, 0.50, 0.01);
    add("bem", 0.2, 0.41, 0.01);
    add("bem", 0.3, 0.40, 0.01);
    const auto differences = model_differences(points);
    ASSERT_EQ(differences.size(), 1u);  // of u_sd; nothing else is known
    EXPECT_EQ(differences[0].n_different(), 1);
    EXPECT_DOUBLE_EQ(differences[0].worst().relative(), 0.25);
    EXPECT_NEAR(differences[0].worst().bar(), 0.05, 1e-12);
    points.pop_back();
    EXPECT_NE(difference_sentence(model_differences(points).at(0))
                  .find("no difference beyond the numerical error"),
              std::string::npos);
    points.back().settled_shift->error = NAN;
    EXPECT_NE(difference_sentence(model_differences(points).at(0)).find("cannot be said"),
              std::string::npos);
}

}  // namespace
}  // namespace tricontact::comparisons

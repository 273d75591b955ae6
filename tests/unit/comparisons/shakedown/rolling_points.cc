#include "comparisons/shakedown/rolling_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "comparisons/shakedown/model_differences.h"
#include "tests/unit/comparisons/shakedown/rolling_study.h"

namespace tricontact::comparisons::rolling_points_test {
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
    const Computed two = value_of_steps({{6, at(6)}, {12, at(12)}});
    EXPECT_NEAR(two.value, 0.4, two.error);
    EXPECT_LT(two.error, 0.03 / 12);
    const Computed three = value_of_steps({{6, at(6)}, {12, at(12)}, {24, at(24)}});
    EXPECT_NEAR(three.value, 0.4, three.error);
    EXPECT_FALSE(value_of_steps({{6, at(6)}}).has_bar());
}

TEST(RollingPoints, LevelsAndStepsOfAPointAreOne) {
    std::vector<RollingRun> runs;
    for (const int level : {0, 1})
        for (const int n : {6, 12}) {
            RollingRun run = rolling_run("bem", 0.5, 0.8, contact::State::ratcheting);
            run.level = level;
            run.steps_per_quarter = n;
            // First order in the steps and in the cells, both of exact coefficients.
            run.results.set(quantities::shift_increment_ratio,
                            0.5 - 0.06 / n + 0.01 * std::pow(2, -level / 2.));
            runs.push_back(run);
        }
    const auto points = rolling_points(runs);
    ASSERT_EQ(points.size(), 1u);
    const Computed& increment = points[0].at(quantities::shift_increment_ratio);
    EXPECT_NEAR(increment.value, 0.5 + 0.01 * std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(increment.value, 0.5, increment.error);
    EXPECT_FALSE(points[0].find(quantities::settled_shift_ratio));
}

TEST(RollingPoints, TurningPointsGiveNoShiftPerPeriod) {
    const auto points = rolling_points({rolling_run("mdr", 0.5, 0.8, contact::State::ratcheting)});
    EXPECT_EQ(points.at(0).state, contact::State::ratcheting);
    EXPECT_FALSE(points.at(0).find(quantities::shift_increment_ratio));
}

TEST(RollingPoints, CyclicSlipSettlesAndWhatIsUndecidedDoesNot) {
    RollingRun to_and_fro = rolling_run("bem-layer", 0.5, 0.2, contact::State::cyclic_slip);
    settle(to_and_fro.results, 0.3);
    const RollingRun moving = rolling_run("bem-layer", 0.5, 0.3, contact::State::undecided);
    const auto points = rolling_points({to_and_fro, moving});
    EXPECT_TRUE(points.at(0).find(quantities::settled_shift_ratio));
    EXPECT_FALSE(points.at(1).find(quantities::settled_shift_ratio));
}

TEST(RollingPoints, WhatLiesOutOfRangeIsLeftOut) {
    RollingRun failed = rolling_run("mdr", 0.5, 0.2, contact::State::shakedown);
    failed.results.set(quantities::amplitude_ratio, {});
    EXPECT_TRUE(
        rolling_points({failed, rolling_run("mdr", 1.5, 0.2, contact::State::shakedown)}).empty());
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
        p.state = contact::State::shakedown;
        p.values[&quantities::settled_shift_ratio] = {u, error};
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
    points.back().values[&quantities::settled_shift_ratio].error = NAN;
    EXPECT_NE(difference_sentence(model_differences(points).at(0)).find("are not distinguishable"),
              std::string::npos);
}

}  // namespace
}  // namespace tricontact::comparisons::rolling_points_test

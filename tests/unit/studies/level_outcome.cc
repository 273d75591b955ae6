// What a refinement keeps of a level comes back.
#include "studies/level_outcome.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "studies/study_kind.h"

namespace tricontact::level_outcome_test {
namespace {

using contact::Surface;

contact::Case pressed() {
    contact::Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.friction.coefficient = .57;
    c.load.normal_force = 20;
    c.load.tangential_force = 0;
    return c;
}

contact::History two_quads() {
    Surface s;
    s.layout = Surface::Layout::nodes;
    s.node_x = {0, 1e-3, 2e-3};
    s.node_y = {0, .5e-3, 1. / 3};
    s.quads = {{0, 1, 2, 0, 1, 2, 0, 1, 2}};
    s.offset = {1e-4, -2e-4};
    s.normal_traction = {123456.789012, 0, std::numeric_limits<double>::quiet_NaN()};
    s.displacement_z = {1. / 3, -2e-9, 0};
    contact::History history;
    history.model = "fem";
    history.scales = {20, 4e-3, 5e-4, 5e5, 4e-4, 11};
    history.snapshots = {{.phase = .25, .surface = {}}, {.phase = 2.75, .surface = s}};
    return history;
}

TEST(LevelOutcome, KeepsTheLastStateToSevenDigits) {
    const contact::Case c = pressed();
    const contact::History history = two_quads();
    io::PointOutcome outcome;
    outcome.results = studies::level_results_text(c, history, 61335.25);
    const studies::LevelState state = studies::level_state_of(outcome);
    EXPECT_EQ(state.normal_stiffness, 61335.25);
    ASSERT_TRUE(state.last);
    EXPECT_EQ(state.last->phase, 2.75);
    const Surface &s = state.last->surface, &given = history.snapshots.back().surface;
    EXPECT_EQ(s.layout, given.layout);
    EXPECT_EQ(s.node_y, given.node_y);
    EXPECT_EQ(s.quads, given.quads);
    EXPECT_EQ(s.offset, given.offset);
    EXPECT_NEAR(s.normal_traction[0] / given.normal_traction[0], 1, 5e-7);
    EXPECT_NE(s.normal_traction[0], given.normal_traction[0]);
    EXPECT_TRUE(std::isnan(s.normal_traction[2]));
    EXPECT_NEAR(s.displacement_z[0], 1. / 3, 1e-7);
    EXPECT_TRUE(s.tangential_traction_x.empty());
    // The text of a worker holds the same, and what others read of a point.
    const auto told =
        nlohmann::ordered_json::parse(studies::level_outcome_text(c, history, 61335.25));
    EXPECT_EQ(told.at("results").dump(), *outcome.results);
    EXPECT_TRUE(told.contains("cpu_s"));
}

TEST(LevelOutcome, HasNothingOfPointsOfSweeps) {
    io::PointOutcome outcome;
    EXPECT_FALSE(studies::level_state_of(outcome).last);
    const auto told = nlohmann::json::parse(studies::outcome_text(pressed(), two_quads()));
    outcome.results = told.at("results").dump();
    const studies::LevelState state = studies::level_state_of(outcome);
    EXPECT_FALSE(state.last || state.normal_stiffness);
    contact::History bare = two_quads();
    bare.snapshots.clear();
    outcome.results = studies::level_results_text(pressed(), bare, {});
    EXPECT_FALSE(studies::level_state_of(outcome).last);
}

}  // namespace
}  // namespace tricontact::level_outcome_test

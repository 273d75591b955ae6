#include "experiments/records/recorded_path.h"

#include <gtest/gtest.h>

#include "contact/base/error.h"
#include "tests/unit/experiments/records/synthetic_record.h"

namespace tricontact::experiments {
namespace {

using tests::SyntheticRecord;

constexpr double rounding = 1e-9;  // of sums over some hundred samples

double normal_at(double t) {
    return 20 - 0.02 * t;
}
double tangential_at(double t) {
    return t < 10 ? 0 : 4 + 0.01 * t;
}

/// Two stages of five periods, loaded at 10 s, forces that change linearly.
Experiment experiment_with_forces() {
    SyntheticRecord synthetic{.rest_before = 40, .unloaded = 10};
    synthetic.stages = {{.amplitude = 1000, .periods = 5}, {.amplitude = 1500, .periods = 6}};
    std::mt19937_64 random(1);
    Experiment experiment;
    experiment.kind = Experiment::Kind::limit;
    experiment.loading = 10;
    experiment.records = {synthetic.make(random)};
    Record& record = experiment.records.front();
    for (const double t : record.time) {
        record.normal_force.push_back(normal_at(t));
        record.tangential_force.push_back(tangential_at(t));
    }
    return experiment;
}

contact::Case rig() {
    contact::Case c;
    c.friction.coefficient = 0.5;
    c.load.normal_force = 25;
    c.load.tangential_force = 5;
    c.rolling.emplace();
    c.rolling->amplitude = 1e-3;
    return c;
}

// The straight lines of least squares are the forces themselves.
TEST(RecordedPath, HoldsWhatWasRecorded) {
    const RecordedPath recorded = recorded_path(experiment_with_forces(), rig(), 2);
    const auto& rows = recorded.path.rows;
    ASSERT_EQ(recorded.upright.size(), 2u);
    EXPECT_EQ(recorded.upright[0].size(), 6u);
    EXPECT_EQ(recorded.upright[1].size(), 7u);
    EXPECT_EQ(recorded.rest_after.size(), 3u);
    EXPECT_EQ(recorded.upright[1].back(), recorded.rest_after.front() - 1);
    // Pressed before F_T acts.
    EXPECT_NEAR(rows[0].normal.value, normal_at(5), 0.02 * 0.05);  // mean up to a sample
    EXPECT_EQ(rows[0].tangential[0].value, 0);
    for (std::size_t r = 1; r < rows.size(); ++r) EXPECT_GT(rows[r].time, rows[r - 1].time) << r;
    // From the rest's second part on times are those of the record, but for their origin.
    const double origin = 50 - rows[static_cast<std::size_t>(recorded.upright[0][0])].time;
    for (std::size_t r = 3; r < rows.size(); ++r) {
        EXPECT_NEAR(rows[r].normal.value, normal_at(rows[r].time + origin), 20 * rounding) << r;
        EXPECT_NEAR(rows[r].tangential[0].value, tangential_at(rows[r].time + origin),
                    20 * rounding)
            << r;
    }
}

TEST(RecordedPath, RollsAsTheDriveDid) {
    const RecordedPath recorded = recorded_path(experiment_with_forces(), rig(), 2);
    const auto& rows = recorded.path.rows;
    for (const auto& stage : recorded.upright)
        for (const int row : stage) EXPECT_EQ(rows[static_cast<std::size_t>(row)].offset[0], 0);
    // The first stage's amplitude to the recorded drive's mean distance.
    const auto turn = static_cast<std::size_t>(recorded.upright[0][0] + 2);
    EXPECT_NEAR(rows[turn].offset[0], 1e-3, 2e-6);
    EXPECT_NEAR(rows[turn + 4].offset[0], -1e-3, 2e-6);
    const auto second = static_cast<std::size_t>(recorded.upright[1][0] + 2);
    EXPECT_NEAR(rows[second].offset[0], 1.5e-3, 3e-6);
}

// The case's own numbers over the recorded means say how a sensor errs.
TEST(RecordedPath, GrowsWithTheNumbersOfTheCase) {
    const RecordedPath recorded = recorded_path(experiment_with_forces(), rig(), 1);
    contact::Case c = rig();
    c.load.normal_force = 1.1 * recorded.normal_force.mean;
    c.load.tangential_force = 0.9 * recorded.tangential_force.mean;
    c.rolling->angle = 0.5;
    const contact::Case followed = recorded.followed_by(c);
    ASSERT_TRUE(followed.prescribed_path);
    EXPECT_FALSE(followed.rolling);
    const auto& rows = followed.prescribed_path->rows;
    ASSERT_EQ(rows.size(), recorded.path.rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const auto& own = recorded.path.rows[r];
        EXPECT_NEAR(rows[r].normal.value, 1.1 * own.normal.value, 1e-12 * own.normal.value);
        EXPECT_NEAR(rows[r].tangential[0].value, 0.9 * own.tangential[0].value, 1e-12);
        EXPECT_NEAR(rows[r].offset[1], own.offset[0] * std::sin(0.5), 1e-8);
    }
}

TEST(RecordedPath, WhatHasNoColumnIsConstant) {
    Experiment experiment = experiment_with_forces();
    experiment.records.front().tangential_force.clear();
    const RecordedPath recorded = recorded_path(experiment, rig(), 1);
    EXPECT_FALSE(recorded.tangential_force.is_recorded);
    EXPECT_TRUE(recorded.normal_force.is_recorded);
    EXPECT_EQ(recorded.path.rows.front().tangential[0].value, 0);
    for (std::size_t r = 1; r < recorded.path.rows.size(); ++r)
        EXPECT_EQ(recorded.path.rows[r].tangential[0].value, 5);
}

// A longer rest than the recorded one, which begins after F_T was applied.
TEST(RecordedPath, AHoldThatTheCaseKnowsPrecedesTheRecord) {
    Experiment experiment = experiment_with_forces();
    experiment.loading.reset();
    contact::Case c = rig();
    const double short_rest = recorded_path(experiment, c, 1).path.rows[6].time;
    c.load.hold = 200;
    const RecordedPath recorded = recorded_path(experiment, c, 1);
    const auto start = static_cast<std::size_t>(recorded.upright[0][0]);
    const double start_time = recorded.path.rows[start].time;
    EXPECT_NEAR(start_time, 200, 1);  // F_T acts within a thousandth of the rest
    EXPECT_LT(short_rest, 60);
}

TEST(RecordedPath, RefusesForcesUnderWhichTheContactSlides) {
    const RecordedPath recorded = recorded_path(experiment_with_forces(), rig(), 1);
    contact::Case c = rig();
    c.load.normal_force = recorded.normal_force.mean;
    c.load.tangential_force = 0.55 * *c.load.normal_force;  // mu is 0.5
    EXPECT_THROW(recorded.followed_by(c), contact::InputError);
}

}  // namespace
}  // namespace tricontact::experiments

#include "experiments/records/drive_timeline.h"

#include <gtest/gtest.h>

#include "contact/base/error.h"
#include "tests/unit/experiments/records/synthetic_record.h"

namespace tricontact::experiments::drive_timeline_test {
namespace {

using tests::SyntheticRecord;

std::string refusal(const Record& record, const Experiment& experiment = {}) {
    try {
        drive_timeline(record, experiment);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(DriveTimeline, FindsPeriodsAndAmplitudesOfARecordedDrive) {
    std::mt19937_64 random(1);
    SyntheticRecord synthetic;
    synthetic.stages = {{.amplitude = 1000, .periods = 3}, {.amplitude = 1050, .periods = 4}};
    for (const double sampling : {0.05, 0.031}) {
        synthetic.sampling = sampling;
        for (const double side : {1., -1.}) {  // whichever the drive goes first
            auto record = synthetic.make(random);
            for (double& w : record.drive) w *= side;
            const DriveTimeline found = drive_timeline(record, {});
            ASSERT_EQ(found.stages.size(), 2U);
            EXPECT_EQ(found.stages[0].periods(), 3);
            EXPECT_EQ(found.stages[1].periods(), 4);
            // Straight flanks: exact but for rounding.
            EXPECT_NEAR(found.start(), 30, 1e-9);
            EXPECT_NEAR(found.stages[0].upright[2], 38, 1e-9);
            EXPECT_NEAR(found.end(), 30 + 12 + 4 * 4.2, 1e-9);
            // Peaks between samples are cut: (sampling/period)^2 of the area.
            EXPECT_NEAR(found.stages[0].amplitude, 1e-3, 1e-6);
            EXPECT_NEAR(found.stages[1].amplitude, 1.05e-3, 1e-6);
        }
    }
}

// Its first period were half as long again on one side, as of another amplitude.
TEST(DriveTimeline, OffsetsCountFromUpright) {
    std::mt19937_64 random(1);
    auto record = SyntheticRecord().make(random);
    for (double& w : record.drive) w += 2e-4;
    EXPECT_EQ(
        refusal(record),
        "run.csv: the drive stands at 0.2 mm before it rolls: its offsets count from the roller "
        "upright, at which periods begin and end; subtract that from the column drive, or record "
        "from upright");
    for (double& w : record.drive) w -= 1.9e-4;
    EXPECT_EQ(refusal(record), "accepted");
}

TEST(DriveTimeline, OfAKnownDrive) {
    std::mt19937_64 random(1);
    SyntheticRecord synthetic;
    synthetic.drive = false;
    const auto record = synthetic.make(random);
    Experiment experiment;
    experiment.drive = {.start = 30, .period = {}, .amplitude = 1e-3, .speed = 1e-3, .periods = 12};
    const DriveTimeline found = drive_timeline(record, experiment);
    EXPECT_NEAR(found.end(), 78, 1e-9);
    const auto recorded = SyntheticRecord().make(random);
    for (std::size_t i = 0; i < record.time.size(); ++i)
        EXPECT_NEAR(found.offset[i], recorded.drive[i], 1e-12);
    experiment.drive.periods = 15;
    EXPECT_EQ(refusal(record, experiment),
              "run.csv: 15 periods of 4 s from 30 s on do not lie in the record, which is from 0 s "
              "to 88 s; correct start, period or periods in [drive]");
}

TEST(ShiftPeriod, IsFoundInShakedownAndRatcheting) {
    std::mt19937_64 random(3);
    for (const double increment : {0., 5.}) {
        SyntheticRecord synthetic;
        synthetic.drive = false;
        synthetic.stages[0].increment = increment;
        // Ratcheting has two steps in each period; 1.5 um of wobble distinguish it from half the
        // period.
        EXPECT_NEAR(shift_period(synthetic.make(random), 30, 12), 4, 0.01);
    }
    SyntheticRecord still;
    still.stages[0] = {.transient = 0};
    still.wobble = 0;
    EXPECT_THROW(shift_period(still.make(random), 30, 12), contact::InputError);
}

TEST(DriveTimeline, RefusesWhatIsNoDrive) {
    std::mt19937_64 random(1);
    SyntheticRecord synthetic;
    auto record = synthetic.make(random);
    std::ranges::fill(record.drive, 0.);
    EXPECT_EQ(refusal(record), "run.csv: the drive does not move; check the column drive");
    record = synthetic.make(random);
    for (double& w : record.drive) w = std::abs(w);
    EXPECT_EQ(refusal(record), "run.csv: the drive completes no period; record at least one");
    synthetic.sampling = 0.2;
    EXPECT_EQ(refusal(synthetic.make(random)),
              "run.csv: the period from 30 s to 34 s has 20 samples, fewer than 32; sample faster");
}

}  // namespace
}  // namespace tricontact::experiments::drive_timeline_test

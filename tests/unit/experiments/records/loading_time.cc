#include "experiments/records/loading_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/base/error.h"
#include "experiments/records/experiment_evaluation.h"

namespace tricontact::experiments::loading_time_test {
namespace {

constexpr double um = 1e-6;

/// 150 um from `loaded` on; rolled from 30 s to 70 s in ten periods that change nothing. Samples at
/// multiples of 1/16 s, which are exact.
Record record_loaded_at(double loaded) {
    Record record{.name = "run.csv", .time = {}, .shift = {}, .drive = {}};
    std::minstd_rand random(1);
    for (int i = 0; i <= 100 * 16; ++i) {
        const double t = i / 16., phase = std::clamp((t - 30) / 4, 0., 10.);
        const double part = phase - std::floor(phase);
        record.time.push_back(t);
        // Three steps to both sides at random: what repeats were a hum.
        const double noise = .05 * um * (static_cast<int>(random() % 7) - 3);
        record.shift.push_back((t >= loaded ? 150 * um : 0) + noise);
        record.drive.push_back(1e-3 * (part < .25   ? 4 * part
                                       : part < .75 ? 2 - 4 * part
                                                    : 4 * part - 4));
    }
    return record;
}

Experiment stated(double loaded, double loading) {
    Experiment experiment;
    experiment.loading = loading;
    experiment.records = {record_loaded_at(loaded)};
    return experiment;
}

// A sample at the stated time is loaded; so are those before it if the load came earlier.
TEST(LoadingTime, IsFoundInTheShift) {
    for (const double early : {0., .2, .5, 1., 5.}) {
        const auto e = evaluate_experiment(stated(10 - early, 10));
        EXPECT_NEAR(e.static_shift.at_95.value, 150 * um, .05 * um) << early;
        EXPECT_EQ(e.runs[0].findings.empty(), early < .2) << early;
        EXPECT_NEAR(e.rest.time, 20 + (early < .2 ? 0 : early), .07);
    }
    const auto late = evaluate_experiment(stated(13, 10));
    EXPECT_NEAR(late.static_shift.at_95.value, 150 * um, .05 * um);
    ASSERT_FALSE(late.runs[0].findings.empty());
    EXPECT_EQ(late.runs[0].findings[0].kind, RecordFinding::Kind::loading);
    EXPECT_EQ(late.runs[0].findings[0].sentence,
              "record.loading is 10 s, but the shift rises at 13 s: the record counts");
}

TEST(LoadingTime, IsRefusedWhereNothingRises) {
    const auto refusal = [](const Experiment& experiment) {
        try {
            evaluate_experiment(experiment);
        } catch (const contact::InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(refusal(stated(-1, 10))
                  .find("run.csv: record.loading = 10 s, but the shift does not "
                        "rise before the rolling"),
              0U);
    EXPECT_EQ(refusal(stated(10, 40))
                  .find("run.csv: record.loading = 40 s is not before the "
                        "rolling, which begins at 30 s"),
              0U);
}

}  // namespace
}  // namespace tricontact::experiments::loading_time_test

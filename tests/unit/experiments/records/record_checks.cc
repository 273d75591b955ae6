#include "experiments/records/record_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "experiments/records/experiment_evaluation.h"
#include "experiments/records/experiment_report.h"
#include "tests/unit/experiments/records/synthetic_record.h"

namespace tricontact::experiments::record_checks_test {
namespace {

using Kind = RecordFinding::Kind;
using tests::SyntheticRecord;

constexpr double um = 1e-6;

std::size_t index_at(const Record& record, double t) {
    return std::size_t(std::ranges::lower_bound(record.time, t) - record.time.begin());
}

/// Loaded at 10 s, rolled from 40 s to 88 s.
SyntheticRecord loaded_record() {
    SyntheticRecord synthetic;
    synthetic.unloaded = 10;
    synthetic.zero = 20;
    synthetic.noise = .12;
    return synthetic;
}

Experiment experiment_of(const Record& record) {
    Experiment experiment;
    experiment.resolution = 80e-9;
    experiment.loading = 10;
    experiment.records = {record};
    return experiment;
}

ExperimentEvaluation evaluated(const Record& record) {
    return evaluate_experiment(experiment_of(record));
}

Record made(std::uint64_t seed = 1) {
    std::mt19937_64 random(seed);
    return loaded_record().make(random);
}

bool has(const ExperimentEvaluation& e, Kind kind) {
    return std::ranges::any_of(e.runs.front().findings,
                               [&](const RecordFinding& f) { return f.kind == kind; });
}

std::string refusal(const Experiment& experiment) {
    try {
        evaluate_experiment(experiment);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "accepted";
}

void cut(Record& record, double from, double to) {
    for (auto* values : {&record.shift, &record.drive, &record.time})
        values->erase(values->begin() + std::ptrdiff_t(index_at(record, from)),
                      values->begin() + std::ptrdiff_t(index_at(record, to)));
}

bool holds(const Estimate& e, double truth) {
    return e.low <= truth && truth <= e.high;
}

TEST(RecordChecks, FindNothingInRecordsThatAreInOrder) {
    int findings = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        findings += !evaluated(made(seed)).runs.front().findings.empty();
    EXPECT_LE(findings, 2);
}

// A spike of 50 um in the zero of 10 s at 20 samples per second would move it by .25 um.
TEST(RecordChecks, OutliersAreLeftOutAndNamed) {
    const auto clean = evaluated(made());
    for (const double at : {5., 30., 50.}) {
        Record record = made();
        for (std::size_t i = 0; i < 3; ++i) record.shift[index_at(record, at) + i] += 50 * um;
        const auto e = evaluated(record);
        EXPECT_TRUE(has(e, Kind::outlier)) << at;
        EXPECT_FALSE(e.is_spoilt());
        EXPECT_NEAR(e.final_shift.at_95.value, clean.final_shift.at_95.value, .02 * um) << at;
        std::string text;
        for (const auto& verdict : experiment_verdicts(e)) text += verdict.sentence;
        EXPECT_NE(text.find("run.csv: 3 samples are left out, the furthest "), std::string::npos)
            << text;
    }
}

TEST(RecordChecks, JumpsSpoilARecord) {
    for (const double at : {25., 55.5}) {
        Record record = made();
        for (std::size_t i = index_at(record, at); i < record.shift.size(); ++i)
            record.shift[i] += 3 * um;
        auto e = evaluated(record);
        EXPECT_TRUE(has(e, Kind::jump)) << at;
        EXPECT_EQ(e.state, contact::State::undecided);
        std::vector<double> shift(std::size_t(e.periods) + 1, 200 * um), raised = shift;
        for (double& u : raised) u *= 1.01;
        add_prediction(e, {"mdr", shift, contact::State::shakedown, 0, {raised}});
        for (const Deviation& d : e.deviations) EXPECT_FALSE(d.differs());
        EXPECT_FALSE(e.series[0].differs());
    }
}

// A contact that slips at once at both turning points of each period, as one that ratchets does, at
// most half as far again as in the period beside: within one sample of 50 ms, 14 standard
// deviations of the noise and more.
TEST(RecordChecks, SlipThatRecursIsNoJump) {
    Record slipping = made();
    constexpr double begin = 40, period = 4, jump = 4 * um;
    for (int n = 0; n < 12; ++n)
        for (const double phase : {.25, .75})
            for (std::size_t i = index_at(slipping, begin + (n + phase) * period);
                 i < slipping.shift.size(); ++i)
                slipping.shift[i] += (2 + 2 * std::pow(.5, n)) * um;
    const auto e = evaluated(slipping);
    EXPECT_FALSE(has(e, Kind::jump));
    EXPECT_FALSE(e.is_spoilt());
    EXPECT_EQ(e.state, contact::State::ratcheting);
    // Of one period alone it is one, whether the contact slips there or not, and also where what
    // the contact does next undoes it.
    for (const double at : {25., 57.03, 58.5, 61.})
        for (const double sign : {-1., 1.}) {
            Record record = slipping;
            for (std::size_t i = index_at(record, at); i < record.shift.size(); ++i)
                record.shift[i] += sign * jump;
            EXPECT_TRUE(has(evaluated(record), Kind::jump)) << at << " s, " << sign;
        }
}

TEST(RecordChecks, ClippedStuckAndDeadSensorsAreNamed) {
    Record clipped = made();
    for (double& u : clipped.shift) u = std::min(u, 115.04 * um);
    EXPECT_TRUE(has(evaluated(clipped), Kind::clipped));
    Record stuck = made();
    const std::size_t first = index_at(stuck, 60.3);
    std::fill(stuck.shift.begin() + std::ptrdiff_t(first),
              stuck.shift.begin() + std::ptrdiff_t(first) + 100, stuck.shift[first]);
    EXPECT_TRUE(has(evaluated(stuck), Kind::stuck));
    Record dead = made();
    std::ranges::fill(dead.shift, 0.);
    EXPECT_NE(refusal(experiment_of(dead)).find("the channel is dead"), std::string::npos);
    // Noise below the resolution repeats values, too.
    SyntheticRecord quiet = loaded_record();
    quiet.noise = .001;
    quiet.drift = 0;
    std::mt19937_64 random(1);
    EXPECT_FALSE(has(evaluated(quiet.make(random)), Kind::stuck));
}

// Whatever part of a period is missing, the reason is not another amplitude.
TEST(RecordChecks, GapsAreNamedOrRefusedByName) {
    int refused = 0, n = 0;
    const SyntheticRecord::Stage truth;
    for (double at = 45; at < 49; at += .1, ++n)
        for (const double length : {.6, 1.}) {
            Record record = made();
            cut(record, at, at + length);
            const std::string message = refusal(experiment_of(record));
            if (message != "accepted") {
                EXPECT_NE(message.find("there is a gap of"), std::string::npos) << message;
                ++refused;
                continue;
            }
            const auto e = evaluated(record);
            EXPECT_TRUE(has(e, Kind::gap));
            EXPECT_NEAR(e.amplitude, 1e-3, 3e-6) << at;
            EXPECT_NEAR(e.final_shift.at_95.value, truth.shift(12) * um, .3 * um);
        }
    EXPECT_LT(refused, n);  // of 2 n: where the roller is upright
    Record long_gap = made();
    cut(long_gap, 51, 54);
    EXPECT_NE(refusal(experiment_of(long_gap)).find("what the drive did there is not known"),
              std::string::npos);
}

TEST(RecordChecks, ADelayedDriveIsNamedAndCounted) {
    Record record = made();
    for (std::size_t i = record.drive.size(); i-- > 0;)
        record.drive[i] = i >= 6 ? record.drive[i - 6] : 0;  // .3 s of a period of 4 s
    const auto e = evaluated(record);
    EXPECT_TRUE(has(e, Kind::delay));
    const SyntheticRecord::Stage truth;
    // Wobble of 1.5 um/mm at 1 mm/s: .45 um off.
    for (const std::size_t n : {std::size_t(4), std::size_t(8)}) {
        const Estimate& u = e.shift[n];
        EXPECT_LT(std::abs(u.value - truth.shift(double(n)) * um), 2 * u.standard_error) << n;
    }
}

TEST(RecordChecks, ADriftThatChangesIsNamedAndCounted) {
    Record record = made();
    for (std::size_t i = 0; i < record.time.size(); ++i)
        record.shift[i] += 5 * um * std::exp(-record.time[i] / 30);
    const auto e = evaluated(record);
    EXPECT_TRUE(has(e, Kind::drift));
    const SyntheticRecord::Stage truth;
    EXPECT_TRUE(holds(e.static_shift.at_95, truth.shift(0) * um));
    EXPECT_TRUE(holds(e.final_shift.at_95, truth.shift(12) * um));
    // Repeats that drift alike do not know less by their scatter.
    Experiment three = experiment_of(record);
    for (const std::uint64_t seed : {2, 3}) {
        Record other = made(seed);
        for (std::size_t i = 0; i < other.time.size(); ++i)
            other.shift[i] += 5 * um * std::exp(-other.time[i] / 30);
        three.records.push_back(other);
    }
    const auto repeats = evaluate_experiment(three);
    EXPECT_TRUE(holds(repeats.final_shift.at_95, truth.shift(12) * um));
    EXPECT_GT(repeats.final_shift.systematic, 0);
}

TEST(RecordChecks, NoiseThatTheRestDoesNotTellIsNamed) {
    SyntheticRecord synthetic = loaded_record();
    synthetic.correlation = std::exp(-.05 / 5);
    std::mt19937_64 random(3);
    EXPECT_TRUE(has(evaluated(synthetic.make(random)), Kind::correlation));
    Record loud = made();
    std::normal_distribution<double> gauss;
    for (std::size_t i = index_at(loud, 40); i < index_at(loud, 88); ++i)
        loud.shift[i] += .6 * um * gauss(random);
    const auto e = evaluated(loud), quiet = evaluated(made());
    EXPECT_TRUE(has(e, Kind::noise));
    EXPECT_GT(e.runs[0].stages[0].noise_error[5], 3 * quiet.runs[0].stages[0].noise_error[5]);
}

}  // namespace
}  // namespace tricontact::experiments::record_checks_test

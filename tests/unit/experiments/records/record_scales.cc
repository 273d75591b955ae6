#include "experiments/records/record_scales.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/records/experiment_evaluation.h"
#include "experiments/records/experiment_report.h"
#include "experiments/records/record_hum.h"
#include "tests/unit/experiments/records/synthetic_record.h"

namespace tricontact::experiments::record_scales_test {
namespace {

using Kind = RecordFinding::Kind;

constexpr double um = 1e-6;

/// Loaded at 10 s, rolled from 40 s to 88 s by 1 mm.
Record made(std::uint64_t seed = 1) {
    tests::SyntheticRecord synthetic;
    synthetic.unloaded = 10;
    synthetic.noise = .12;
    std::mt19937_64 random(seed);
    return synthetic.make(random);
}

ExperimentEvaluation evaluated(const Record& record) {
    Experiment experiment;
    experiment.resolution = 80e-9;
    experiment.loading = 10;
    experiment.records = {record};
    return evaluate_experiment(experiment);
}

std::string sentences(const ExperimentEvaluation& e) {
    std::string text;
    for (const auto& verdict : experiment_verdicts(e)) text += verdict.sentence + '\n';
    return text;
}

bool finds(const ExperimentEvaluation& e, Kind kind) {
    return std::ranges::any_of(e.runs.front().findings,
                               [&](const RecordFinding& f) { return f.kind == kind; });
}

TEST(RecordScales, AShiftAgainstTheForceIsNotCompared) {
    Record record = made();
    EXPECT_FALSE(finds(evaluated(record), Kind::sign));
    for (double& u : record.shift) u = -u;
    const auto e = evaluated(record);
    EXPECT_TRUE(finds(e, Kind::sign));
    EXPECT_TRUE(e.is_spoilt());
    EXPECT_EQ(e.state, contact::State::undecided);
    EXPECT_NE(sentences(e).find("the shift under F_T is −60"), std::string::npos) << sentences(e);
    record.tangential_force.assign(record.time.size(), -6.7);  // which it follows
    EXPECT_FALSE(finds(evaluated(record), Kind::sign));
}

TEST(RecordScales, UnitsThatTheResolutionContradictsAreNamed) {
    EXPECT_FALSE(finds(evaluated(made()), Kind::unit));
    for (const double factor : {1e-3, 1e3}) {
        Record record = made();
        for (double& u : record.shift) u *= factor;
        EXPECT_TRUE(finds(evaluated(record), Kind::unit)) << factor;
    }
    EXPECT_FALSE(power_of_thousand(1, .5));
    EXPECT_FALSE(power_of_thousand(31, .5));
    EXPECT_DOUBLE_EQ(power_of_thousand(1.4e-3, .5).value(), 1e-3);
    EXPECT_DOUBLE_EQ(power_of_thousand(.99e6, .02).value(), 1e6);
}

// A quantity that was measured a thousand times as large as computed.
TEST(RecordScales, UnitsThatTheModelContradictsAreNamed) {
    for (const double factor : {1., 1e3}) {
        Record record = made();
        for (double& u : record.shift) u *= factor;
        auto e = evaluated(record);
        std::vector<double> shift(std::size_t(e.periods) + 1, 70 * um), raised = shift;
        for (double& u : raised) u *= 1.01;
        add_prediction(e, {"mdr", shift, contact::State::shakedown, 0, {raised}});
        EXPECT_EQ(sentences(e).find("measured some 1000 times as large") != std::string::npos,
                  factor > 1);
    }
}

TEST(RecordScales, StepsThatAreCoarserThanStatedCount) {
    Record record = made();
    for (double& u : record.shift) u = 2 * um * std::round(u / (2 * um));
    const auto e = evaluated(record);
    EXPECT_TRUE(finds(e, Kind::resolution));
    EXPECT_NEAR(e.runs[0].noise.resolution, 2 * um, 1e-12);
    const tests::SyntheticRecord::Stage truth;
    const Estimate& u = e.static_shift.at_95;
    EXPECT_LT(std::abs(u.value - truth.shift(0) * um), u.half_width());
}

// W by the mean distance is off by 27 % where the drive is a sine, by 4 % where it is clipped at
// .8 W on both sides.
TEST(RecordScales, DrivesThatAreNoTriangleAreNotCompared) {
    const auto with_drive = [](auto&& changed) {
        Record record = made();
        for (double& w : record.drive) w = changed(w);
        return evaluated(record);
    };
    const auto clipped = with_drive([](double w) { return std::clamp(w, -.8e-3, .8e-3); });
    const auto one_side = with_drive([](double w) { return std::min(w, .7e-3); });
    const auto sine =
        with_drive([](double w) { return 1e-3 * std::sin(std::numbers::pi / 2 * w / 1e-3); });
    for (const auto* e : {&clipped, &one_side, &sine}) {
        EXPECT_TRUE(finds(*e, Kind::drive));
        EXPECT_TRUE(e->is_spoilt());
        EXPECT_EQ(e->state, contact::State::shakedown);  // the shift says so, whatever the drive
    }
    const auto triangle = with_drive([](double w) { return w; });
    EXPECT_FALSE(finds(triangle, Kind::drive));
    EXPECT_FALSE(triangle.is_spoilt());
}

// A line of .4 um beside noise of .12 um; without one noise has none, whatever its memory.
TEST(RecordHum, ALineIsNamedAndNoiseIsNone) {
    Record record = made();
    for (std::size_t i = 0; i < record.time.size(); ++i)
        record.shift[i] += .4 * um * std::sin(2 * std::numbers::pi * 3.21 * record.time[i]);
    const auto e = evaluated(record);
    EXPECT_TRUE(finds(e, Kind::hum));
    EXPECT_NE(sentences(e).find("the shift hums at 3."), std::string::npos) << sentences(e);
    std::mt19937_64 random(5);
    std::normal_distribution<double> gauss;
    RecordFindings findings;
    constexpr int n_stretches = 400;
    for (const double memory : {0., 1., 20., 400.})  // samples
        for (int k = 0; k < n_stretches; ++k) {
            const double kept = memory > 0 ? std::exp(-1 / memory) : 0;
            double value = gauss(random);
            std::vector<double> noise;
            for (int i = 0; i < 300; ++i) {
                value = kept * value + std::sqrt(1 - kept * kept) * gauss(random);
                noise.push_back(um * value);
            }
            find_hum(noise, .05, 0, findings);
        }
    EXPECT_LE(findings.size(), 8u);  // 1.6 of 1600 expected, and five standard deviations
}

// A shift that grows has no end that could be extrapolated.
TEST(RecordScales, RatchetingIsNotExtrapolated) {
    tests::SyntheticRecord ratcheting;
    EXPECT_NE(sentences(evaluated(made())).find("; extrapolated "), std::string::npos);
    ratcheting.stages[0].increment = 20;
    std::mt19937_64 random(1);
    const auto e = tests::evaluated(ratcheting, random);
    EXPECT_EQ(e.state, contact::State::ratcheting);
    EXPECT_EQ(sentences(e).find("extrapolated"), std::string::npos) << sentences(e);
}

}  // namespace
}  // namespace tricontact::experiments::record_scales_test

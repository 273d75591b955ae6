#include "walking/report/walk_document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/walking/sets.h"
#include "walking/machine/linear_stability.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/run/walk_readings.h"

namespace tricontact::walking::walk_document_test {
namespace {

using Standing = report::Verdict::Standing;

WalkReport run_of(const Machine& machine, double end) {
    WalkReport report;
    report.walk_case.machine = machine;
    report.walk_case.time.end = end;
    report.walk = walk(report.walk_case, report_recording);
    return report;
}

/// Set B on its limit cycle, which it reaches at t = 600 from rest.
const WalkReport& walking_set_b() {
    static const WalkReport report = run_of({.kappas = walking::set_b()}, 1500);
    return report;
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

const report::Figure& figure(const report::Document& document, const std::string& id) {
    for (const report::DocumentSection& section : document.sections)
        for (const report::Figure& each : section.figures)
            if (each.id == id) return each;
    throw std::invalid_argument("no figure " + id);
}

// Numbers of set B: an independent program's, to their last digit.
TEST(WalkDocument, TellsWhatALimitCycleIs) {
    const report::Document document = walk_document(walking_set_b());
    ASSERT_EQ(document.verdicts.size(), 7u);
    EXPECT_TRUE(contains(document.verdicts[0].sentence, "limit cycle of period 4.29"));
    EXPECT_TRUE(contains(document.verdicts[0].sentence, "95.6 % less friction"));
    EXPECT_TRUE(contains(document.verdicts[1].sentence, "jumps 0.4289 static"));
    EXPECT_TRUE(contains(document.verdicts[2].sentence, "r_1 = −0.759, r_2 = −0.727"));
    EXPECT_TRUE(contains(document.verdicts[3].sentence, "neither diverge nor converge"));
    EXPECT_TRUE(contains(document.verdicts[4].sentence, "0.2329"));
    EXPECT_EQ(document.verdicts[5].standing, Standing::pass);
    EXPECT_NO_THROW(report::document_html(document));
}

// Springs of a bed go on from where each of them is, not from where their spot is.
TEST(WalkDocument, BalancesTheEnergyOfRoundedTips) {
    Machine machine{.kappas = walking::set_b()};
    machine.bed = Bed{.radius = 0.5, .springs = 10};
    const auto energy = energy_of(run_of(machine, 60));
    ASSERT_TRUE(energy);
    EXPECT_GT(energy->balance.dissipation, 0);
    EXPECT_LT(std::abs(energy->balance.residual()) / energy->scale, 1e-6);
}

// What a period on the limit cycle takes from the base is <f_s> kappa6 T; nothing is stored.
TEST(WalkDocument, BalancesTheEnergyOfAPeriod) {
    const auto energy = energy_of(walking_set_b());
    ASSERT_TRUE(energy);
    const Kappas kappas = walking::set_b();
    const double work = 0.0440 * kappas.kappa5 * kappas.kappa4 * kappas.kappa6 *
                        *walking_set_b().walk.result.period;
    EXPECT_NEAR(energy->balance.base / work, 1, 0.02);  // a step more or less at 40 times the mean
    EXPECT_LT(std::abs(energy->balance.residual()) / energy->balance.base, 1e-6);
}

TEST(WalkDocument, SaysWhereTheStepLosesEnergy) {
    WalkReport report = walking_set_b();
    report.walk_case.time.step = 0.02;
    const auto energy = energy_of(report);
    ASSERT_TRUE(energy);
    const report::Verdict verdict = energy_verdict(report, *energy);
    EXPECT_EQ(verdict.standing, Standing::fail);
    EXPECT_TRUE(contains(verdict.sentence, "smaller [time] step"));
}

// z of two alike spots vibrates on its own, at sqrt(2 kappa2); x and phi on springs: neutral. With
// the weight ahead of the middle of the base they drive each other above some friction.
TEST(WalkDocument, TellsWhetherSlidingIsStable) {
    const Machine symmetric{.kappas = walking::set_b()};
    const Eigenvalues neutral = sliding_stability(symmetric);
    ASSERT_EQ(neutral.size(), 3u);
    EXPECT_TRUE(contains(stability_verdict(walking_set_b(), neutral).sentence, "linearly neutral"));
    bool vertical = false;
    for (const auto& value : neutral)
        vertical |= std::abs(value.imag() - std::sqrt(2 * symmetric.kappas.kappa2)) < 1e-9;
    EXPECT_TRUE(vertical);
    Machine ahead{.kappas = walking::set_b(),
                  .model = Machine::Model::spots,
                  .spots = {{.position = -0.5}, {.position = 1.5}}};
    const auto onset = flutter_friction(ahead, 2);
    ASSERT_TRUE(onset);
    ahead.kappas.kappa5 = 0.9 * *onset;
    EXPECT_TRUE(contains(stability_verdict({}, sliding_stability(ahead)).sentence, "neutral"));
    ahead.kappas.kappa5 = 1.1 * *onset;
    EXPECT_TRUE(contains(stability_verdict({}, sliding_stability(ahead)).sentence, "flutters"));
}

// In the prism of the rig, Wetter (2016), set 5, a small disturbance of steady sliding grows as its
// leading eigenvalue says, from [40, 60] to [100, 120].
TEST(WalkDocument, SlidingOfTheRigFluttersAsItsEigenvalueSays) {
    const Machine rig{.kappas = {2, 1.33, 1.51, 2e-4, 0.75, 1.6e-3, 1.77, -0.47},
                      .model = Machine::Model::prism};
    const Eigenvalues stability = sliding_stability(rig);
    EXPECT_TRUE(contains(stability_verdict({}, stability).sentence, "flutters"));
    Motion disturbed = *steady_sliding(rig);
    const double sliding = disturbed.z;
    disturbed.z *= 1 + 1e-5;
    VelocityVerlet run(rig, disturbed, 1e-3);
    const auto amplitude_until = [&](double end) {
        double greatest = 0;
        while (run.motion().time < end) {
            run.advance();
            greatest = std::max(greatest, std::abs(run.motion().z - sliding));
        }
        return greatest;
    };
    amplitude_until(40);
    const double before = amplitude_until(60);
    amplitude_until(100);
    const double rate = std::log(amplitude_until(120) / before) / 60;
    // The last extreme lies within half a swing of the end, 1.74: a growth of 0.075 times that.
    EXPECT_NEAR(rate, stability.front().real(), 0.13 / 60);
}

TEST(WalkDocument, DrawsWholePeriods) {
    const report::Document document = walk_document(walking_set_b());
    const report::Figure& motion = figure(document, "motion");
    constexpr double sampled = 0.05;
    EXPECT_NEAR(motion.curves[1].x.back(), 3 * 4.2930, sampled);
    const auto [low, high] =
        std::minmax_element(motion.curves[1].y.begin(), motion.curves[1].y.end());
    constexpr double between_samples = 0.002;  // z'' <= 2.1 z_stat over half an interval, squared
    EXPECT_NEAR(*low, -0.4289, between_samples);
    EXPECT_NEAR(*high, 2.3545, between_samples);
    // The phases follow each other on the curve of z, the turning point at its top.
    const std::vector<report::Curve>& period = figure(document, "period").curves;
    const auto mark = [&](int phase) { return period[period.size() - 5 + phase]; };
    for (int phase = 1; phase < 4; ++phase)
        EXPECT_LT(mark(phase).x.front(), mark(phase + 1).x.front());
    EXPECT_NEAR(mark(2).y.front(), 2.3545, between_samples);
    EXPECT_LT(mark(4).y.front(), 0);
}

// On the limit cycle the forces of the spots balance the weight in the mean: no mean acceleration.
TEST(WalkDocument, ForcesOfTheSpotsBalanceTheWeight) {
    const report::Document document = walk_document(walking_set_b());
    double weight = 0;
    for (const char* id : {"spot_1", "spot_2"}) {
        const std::vector<double>& force = figure(document, id).curves[0].y;
        for (std::size_t i = 1; i < force.size(); ++i)
            weight += force[i] / static_cast<double>(force.size() - 1);
    }
    EXPECT_NEAR(weight, 1, 0.01);  // the stretch is whole periods to an interval of 258
}

TEST(WalkDocument, FindsTheLimitCyclesFrequencyInTheSpectrum) {
    const auto vibration = vibration_of(walking_set_b().walk_case.machine, walking_set_b().walk);
    ASSERT_TRUE(vibration);
    const double frequency = 1 / *walking_set_b().walk.result.period;
    EXPECT_NEAR(vibration->characteristic.frequency / frequency, 1, 1e-4);
    EXPECT_EQ(vibration->instability, 1);
}

TEST(WalkDocument, SaysWhereARunIsTooShort) {
    const report::Document document = walk_document(run_of({.kappas = walking::set_b()}, 150));
    EXPECT_EQ(document.verdicts[0].standing, Standing::not_resolved);
    EXPECT_TRUE(contains(document.verdicts[0].sentence, "Too short"));
    EXPECT_NO_THROW(report::document_html(document));
}

TEST(WalkDocument, SteadySlidingHasNoReturnMap) {
    const report::Document document = walk_document(run_of({.kappas = walking::set_a()}, 1500));
    EXPECT_TRUE(contains(document.verdicts[0].sentence, "Slides steadily"));
    EXPECT_THROW(figure(document, "returns"), std::invalid_argument);
    EXPECT_NO_THROW(report::document_html(document));
}

TEST(WalkDocument, OfAFallNamesTheCriticalFriction) {
    Machine machine{.kappas = walking::set_b()};
    machine.kappas.kappa5 = 2;
    const report::Document document = walk_document(run_of(machine, 5000));
    ASSERT_EQ(document.verdicts.size(), 2u);
    EXPECT_TRUE(contains(document.verdicts[0].sentence, "Falls over"));
    EXPECT_TRUE(contains(document.verdicts[0].sentence, "above μ_c = 0.9174"));
    EXPECT_TRUE(contains(document.verdicts[1].sentence, "no steady sliding"));
    EXPECT_NO_THROW(report::document_html(document));
}

TEST(WalkDocument, StandsWithoutFrictionWithoutDragAndWithManySpots) {
    Machine machine{.kappas = walking::set_b()};
    machine.kappas.kappa5 = 0;
    const report::Document frictionless = walk_document(run_of(machine, 60));
    EXPECT_TRUE(contains(frictionless.verdicts[0].sentence, "μ = 0"));
    EXPECT_NO_THROW(report::document_html(frictionless));
    machine.kappas = walking::set_b();
    machine.kappas.kappa6 = 0;
    EXPECT_NO_THROW(report::document_html(walk_document(run_of(machine, 60))));
    machine = {.kappas = walking::set_b(), .model = Machine::Model::spots};
    for (int i = -2; i <= 2; ++i) machine.spots.push_back({.position = i / 2.});
    const report::Document many = walk_document(run_of(machine, 60));
    EXPECT_EQ(figure(many, "spots").curves.size(), 3u);
    EXPECT_THROW(figure(many, "spot_1"), std::invalid_argument);
    EXPECT_NO_THROW(report::document_html(many));
}

TEST(WalkDocument, HasHertzWhereTheCaseHasDimensions) {
    WalkReport report = walking_set_b();
    report.walk_case.dimensional = with_dimensions(report.walk_case.machine.kappas, 0.49, 14e-3);
    const double hertz =
        1 / *report.walk.result.period / characteristic_time(*report.walk_case.dimensional);
    const report::Document document = walk_document(report);
    const report::DocumentTable& table = document.sections[3].tables.front();
    ASSERT_EQ(table.id, "frequencies");
    ASSERT_EQ(table.columns.size(), 3u);
    EXPECT_NEAR(std::get<report::WithError>(table.rows[1][2]).value / hertz, 1, 1e-12);
}

}  // namespace
}  // namespace tricontact::walking::walk_document_test

// Sentences of a walking machine's report, and machines of which they must not be said.
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/walking/sets.h"
#include "walking/report/walk_document.h"

namespace tricontact::walking::walk_sentences_test {
namespace {

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Wetter (2016), table 4.3.2, set 5.
Machine set_5() {
    return {.kappas = {2, 1.33, 1.51, 2e-4, 0.75, 1.6e-3, 1.77, -0.47},
            .model = Machine::Model::prism};
}

Vibration vibration() {
    Vibration v;
    v.spectrum.resolution = 0.1;
    v.spectrum.amplitudes = {1, 0.5};
    v.characteristic = {0.25, 0.01};
    v.free_flight = 0.25;
    v.window = 40;
    v.variances = {0.1, 0.2};
    v.interval = 1;
    return v;
}

WalkReport report_of(const Machine& machine) {
    WalkReport report;
    report.walk_case.machine = machine;
    report.walk.result.regime = Regime::steady;
    report.walk.result.transient_over = true;
    report.walk.result.mu_e = 1;
    return report;
}

std::string paragraphs_of(const Machine& machine) {
    const report::DocumentSection section = vibration_section(report_of(machine), vibration());
    std::string text;
    for (const std::string& paragraph : section.paragraphs) text += paragraph;
    for (const report::Figure& figure : section.figures) text += figure.caption;
    return text;
}

TEST(WalkSentences, TheThesisFrequencyStandsBesideItsSet5Only) {
    const std::string remark = "has 0.1 ± 0.006 for his simulations of set 5";
    EXPECT_TRUE(says(paragraphs_of(set_5()), remark));
    Machine slower = set_5();  // the thesis varies the velocity
    slower.kappas.kappa6 *= 10;
    EXPECT_TRUE(says(paragraphs_of(slower), remark));
    for (double Kappas::*kappa :
         {&Kappas::kappa1, &Kappas::kappa2, &Kappas::kappa3, &Kappas::kappa5, &Kappas::kappa7}) {
        Machine other = set_5();
        other.kappas.*kappa *= 1.1;
        EXPECT_FALSE(says(paragraphs_of(other), remark));
    }
    Machine flat = set_5();
    flat.model = Machine::Model::two_spot;
    EXPECT_FALSE(says(paragraphs_of(flat), remark));
    EXPECT_FALSE(says(paragraphs_of(set_5()), "is printed"));
}

TEST(WalkSentences, SlidingThatFluttersIsNotNeutral) {
    const std::string neutral = "Sliding is linearly neutral";
    const auto text = [](const Machine& machine) {
        std::string all;
        for (const report::Verdict& verdict : walk_verdicts(report_of(machine), vibration()))
            all += verdict.sentence + '\n';
        return all;
    };
    EXPECT_TRUE(says(text({.kappas = walking::set_b()}), neutral));
    EXPECT_FALSE(says(text(set_5()), neutral));
}

std::string first_sentence(const WalkReport& report) {
    return walk_verdicts(report, {}).front().sentence;
}

// Each word about sliding stands with its condition, and not without it.
TEST(WalkSentences, SlidesSteadilyOnlyWhatSlides) {
    WalkReport report = report_of({.kappas = walking::set_b()});
    report.walk.result.spots = {{.stick_time = 0}, {.stick_time = 0}};
    EXPECT_TRUE(says(first_sentence(report), "Slides steadily"));
    EXPECT_TRUE(says(first_sentence(report), "mean spring force has no trend"));
    // What sticks takes from the force of sliding, or it sticks for instants only.
    report.walk.result.spots[1].stick_time = 0.3;
    report.walk.result.mu_e = 0.998, report.walk.result.mu_e_error = 0.003;
    EXPECT_TRUE(says(first_sentence(report), "Slides steadily"));
    report.walk.result.mu_e_error = 0.001;
    EXPECT_FALSE(says(first_sentence(report), "steadily"));
    EXPECT_TRUE(says(first_sentence(report), "sticking for up to 30.0 % of the time"));
    report.walk.result.transient_over = false;
    EXPECT_FALSE(says(first_sentence(report), "Slides"));
    EXPECT_TRUE(says(first_sentence(report), "Too short"));
    report.walk_case.machine.kappas.kappa6 = 0;
    report.walk.result.transient_over = true;
    EXPECT_TRUE(says(first_sentence(report), "The base rests"));
    EXPECT_FALSE(says(first_sentence(report), "lides"));
}

// mu kappa4 (1/kappa1 + 1/2)/kappa6 = 6.8e-5/1e-9 without the turn of the body.
TEST(WalkSentences, WhatSticksHasNoFrictionToTell) {
    WalkReport report = report_of({.kappas = walking::set_b()});
    report.walk_case.machine.kappas.kappa6 = 1e-9;
    report.walk_case.time.end = 20000;
    report.walk.result.regime = Regime::sticking;
    report.walk.result.transient_over = false;
    // kappa1 x_s/(mu kappa4) = 2 * 1.7e-5/6.8e-5
    report.walk.tail = {{.motion = {.base = 1.7e-5}, .spots = {}}};
    const std::string text = first_sentence(report);
    EXPECT_TRUE(says(text, "Does not slide yet")) << text;
    EXPECT_TRUE(says(text, "50.0 % of the force of steady sliding")) << text;
    EXPECT_TRUE(says(text, "until t = 68000")) << text;
    EXPECT_FALSE(says(text, "μ_e"));
    EXPECT_EQ(walk_verdicts(report, vibration()).size(), 1u);
}

TEST(WalkSentences, ChaosIsSaidToLastAsLongAsItWasSeen) {
    WalkReport report = report_of({.kappas = walking::set_b()});
    report.walk.result.regime = Regime::chaotic;
    report.walk.result.observed = 18000;
    EXPECT_TRUE(says(first_sentence(report), "mean life is above 6000"));
    report.walk.result.transient_over = false;
    report.walk.result.phi_min = -0.6 * tilting_limit(report.walk_case.machine);
    EXPECT_TRUE(says(first_sentence(report), "60 % of where it falls over"));
    report.walk.result.phi_min = -0.01 * tilting_limit(report.walk_case.machine);
    EXPECT_FALSE(says(first_sentence(report), "falls over"));
}

TEST(WalkSentences, MicroWalkingIsThatOfAllSpots) {
    const auto text = [](std::vector<double> correlations) {
        WalkReport report = report_of({.kappas = walking::set_b()});
        report.walk.result.regime = Regime::limit_cycle;
        report.walk.result.period = 10;
        for (const double r : correlations)
            report.walk.result.spots.push_back({.stick_time = 0.4, .correlation = r});
        std::string all;
        for (const report::Verdict& verdict : walk_verdicts(report, {}))
            all += verdict.sentence + '\n';
        return all;
    };
    const std::string walking = "micro-walking", little = "depends little";
    EXPECT_TRUE(says(text({-0.8, -0.6}), walking));
    EXPECT_TRUE(says(text({-0.4, 0.2}), little));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto& mixed : {std::vector<double>{-0.9, -0.4}, {0.9, 0.8}, {nan, nan}, {nan, 0}}) {
        EXPECT_FALSE(says(text(mixed), walking));
        EXPECT_FALSE(says(text(mixed), little));
        EXPECT_TRUE(says(text(mixed), "Correlations of velocity"));
    }
}

}  // namespace
}  // namespace tricontact::walking::walk_sentences_test

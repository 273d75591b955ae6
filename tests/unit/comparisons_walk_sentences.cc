// Sentences of a walking machine's report, and machines of which they must not be said.
#include <gtest/gtest.h>

#include <limits>

#include "comparisons/walking/vibration_section.h"
#include "comparisons/walking/walk_verdicts.h"
#include "dynamics_sets.h"

namespace tricontact::comparisons::walking {
namespace {

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Wetter (2016), table 4.3.2, set 5.
dynamics::Machine set_5() {
    return {.kappas = {2, 1.33, 1.51, 2e-4, 0.75, 1.6e-3, 1.77, -0.47},
            .model = dynamics::Machine::Model::prism};
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

WalkReport report_of(const dynamics::Machine& machine) {
    WalkReport report;
    report.walk_case.machine = machine;
    report.walk.result.regime = dynamics::Regime::steady;
    report.walk.result.transient_over = true;
    report.walk.result.mu_e = 1;
    return report;
}

std::string paragraphs_of(const dynamics::Machine& machine) {
    const DocumentSection section = vibration_section(report_of(machine), vibration());
    std::string text;
    for (const std::string& paragraph : section.paragraphs) text += paragraph;
    for (const Figure& figure : section.figures) text += figure.caption;
    return text;
}

TEST(WalkSentences, TheThesisFrequencyStandsBesideItsSet5Only) {
    const std::string remark = "has 0.1 ± 0.006 for his simulations of set 5";
    EXPECT_TRUE(says(paragraphs_of(set_5()), remark));
    dynamics::Machine slower = set_5();  // the thesis varies the velocity
    slower.kappas.kappa6 *= 10;
    EXPECT_TRUE(says(paragraphs_of(slower), remark));
    for (double dynamics::Kappas::*kappa :
         {&dynamics::Kappas::kappa1, &dynamics::Kappas::kappa2, &dynamics::Kappas::kappa3,
          &dynamics::Kappas::kappa5, &dynamics::Kappas::kappa7}) {
        dynamics::Machine other = set_5();
        other.kappas.*kappa *= 1.1;
        EXPECT_FALSE(says(paragraphs_of(other), remark));
    }
    dynamics::Machine flat = set_5();
    flat.model = dynamics::Machine::Model::two_spot;
    EXPECT_FALSE(says(paragraphs_of(flat), remark));
    EXPECT_FALSE(says(paragraphs_of(set_5()), "is printed"));
}

TEST(WalkSentences, SlidingThatFluttersIsNotNeutral) {
    const std::string neutral = "Sliding is linearly neutral";
    const auto text = [](const dynamics::Machine& machine) {
        std::string all;
        for (const Verdict& verdict : walk_verdicts(report_of(machine), vibration()))
            all += verdict.sentence + '\n';
        return all;
    };
    EXPECT_TRUE(says(text({.kappas = dynamics::set_b()}), neutral));
    EXPECT_FALSE(says(text(set_5()), neutral));
}

TEST(WalkSentences, MicroWalkingIsThatOfAllSpots) {
    const auto text = [](std::vector<double> correlations) {
        WalkReport report = report_of({.kappas = dynamics::set_b()});
        report.walk.result.regime = dynamics::Regime::limit_cycle;
        report.walk.result.period = 10;
        for (const double r : correlations)
            report.walk.result.spots.push_back({.stick_time = 0.4, .correlation = r});
        std::string all;
        for (const Verdict& verdict : walk_verdicts(report, {})) all += verdict.sentence + '\n';
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
}  // namespace tricontact::comparisons::walking

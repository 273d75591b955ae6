#include <gtest/gtest.h>

#include "tests/unit/walking/sets.h"
#include "walking/report/walk_document.h"
#include "walking/report/walk_sweep_document.h"

namespace tricontact::walking::walk_scenarios_test {
namespace {

// Two pulls, moments from 0.1 to 1.0 of the weight times b; what runs came to follows the limits.
WalkSweep rocking() {
    WalkSweep sweep{.title = "Rocking",
                    .settings = {},
                    .axes = {{"start.base", ""}, {"excitation.moment", ""}},
                    .points = {}};
    for (const double pull : {0.65, 0.25}) {
        for (int i = 1; i <= 10; ++i) {
            Machine machine{.kappas = walking::set_b()};
            machine.kappas.kappa6 = 0;
            machine.kappas.kappa8 = -1;
            machine.excitation = {.moment = 0.1 * i * machine.kappas.kappa4, .frequency = 0.05};
            const bool settles = 0.1 * i < 1 - pull, flies = i == 10;
            WalkOutcome outcome;
            outcome.result = {.regime = flies     ? Regime::walking
                                        : settles ? Regime::shakedown
                                                  : Regime::ratcheting,
                              .mu_e = pull,
                              .spots = {{1, 0}, {1, 0}}};
            outcome.result.drift = {flies ? 50. : settles ? 0. : 0.1 * i, 1e-3, flies ? 0.3 : 0.};
            sweep.points.push_back({.values = {1000 * pull, machine.excitation.moment},
                                    .machine = machine,
                                    .outcome = outcome});
        }
    }
    return sweep;
}

TEST(WalkScenarios, AreDrawnWithTheirLimits) {
    const report::Document document = walk_sweep_document(rocking());
    ASSERT_EQ(document.sections.front().id, "scenarios");
    const report::Figure& shifts = document.sections.front().figures.front();
    ASSERT_EQ(shifts.curves.size(), 6u);  // two pulls, two limits each
    EXPECT_EQ(shifts.curves[0].name, "f = 0.25");
    EXPECT_EQ(shifts.curves[0].x.size(), 9u);  // what flies would hide the rest
    EXPECT_NEAR(shifts.curves[0].x.front(), 0.1, 1e-12);
    EXPECT_NEAR(shifts.curves[2].x.front(), 0.75, 1e-12);  // 1 - f
    EXPECT_NEAR(shifts.curves[3].x.front(), 1, 1e-12);
    EXPECT_NEAR(shifts.curves[4].x.front(), 0.35, 1e-12);
    EXPECT_EQ(document.sections.front().figures[1].curves[0].x.size(), 10u);
    EXPECT_EQ(document.sections.front().tables.front().rows.size(), 20u);
    EXPECT_EQ(document.verdicts[1].sentence, "10 runs shake down, 8 ratchet, 2 walk, 0 tilt.");
    EXPECT_EQ(document.verdicts[2].sentence,
              "Pulled by f = 0.25: shakedown from m = 0.1 to 0.7, ratcheting from m = 0.8 to 0.9, "
              "walking at m = 1. Quasi-static, it shakes down up to m = 0.750 and a spot "
              "leaves the ground above 1.00.");
    EXPECT_FALSE(report::document_html(document).empty());
}

TEST(WalkScenarios, AreNotThoseOfADraggedMachine) {
    WalkSweep sweep = rocking();
    for (WalkSweep::Point& point : sweep.points) point.machine.kappas.kappa6 = 1e-4;
    EXPECT_NE(walk_sweep_document(sweep).sections.front().id, "scenarios");
}

TEST(WalkScenarios, AreKeptInTheStore) {
    const WalkOutcome outcome = *rocking().points.back().outcome;
    const WalkOutcome back = read_walk_results(walk_results(outcome));
    EXPECT_EQ(back.result.regime, Regime::walking);
    ASSERT_TRUE(back.result.drift);
    EXPECT_EQ(back.result.drift->per_period, 50);
    EXPECT_EQ(back.result.drift->error, 1e-3);
    EXPECT_EQ(back.result.drift->airborne, 0.3);
    WalkOutcome dragged = outcome;
    dragged.result.drift.reset();
    EXPECT_FALSE(read_walk_results(walk_results(dragged)).result.drift);
}

TEST(WalkScenarios, OfOneRunComeFirstInItsReport) {
    WalkReport report;
    Machine& machine = report.walk_case.machine;
    machine = {.kappas = walking::set_b(), .bed = Bed{.radius = 0.05, .springs = 24}};
    machine.kappas.kappa1 = 1e-5;
    machine.kappas.kappa6 = 0;
    machine.kappas.kappa8 = -1;
    machine.excitation = {.moment = 0.7 * machine.kappas.kappa4, .frequency = 0.1};
    report.walk_case.start.base = 0.5 * machine.kappas.kappa5 * machine.kappas.kappa4 /
                                  machine.kappas.kappa1 / static_displacement(machine);
    report.walk_case.time = {.step = 0.04, .end = 1000};  // 15 periods
    report.walk = walk(report.walk_case, report_recording);
    const std::vector<report::Verdict> verdicts = walk_verdicts(report, {});
    ASSERT_EQ(verdicts.size(), 1u);
    EXPECT_TRUE(
        verdicts[0].sentence.starts_with("Pulled by f = 0.500 of its friction, it ratchets"))
        << verdicts[0].sentence;
    EXPECT_NE(verdicts[0].sentence.find("m = 0.7 of the weight; quasi-static, the machine shakes "
                                        "down up to 0.500"),
              std::string::npos)
        << verdicts[0].sentence;
    EXPECT_FALSE(report::document_html(walk_document(report)).empty());
}

}  // namespace
}  // namespace tricontact::walking::walk_scenarios_test

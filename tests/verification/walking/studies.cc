// Studies of the walking machine against the numbers that an independent program found for those of
// Wetter (2016), section 4.2.2 and table 4.2.1.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/verification/walking/side_by_side.h"
#include "walking/run/walk.h"
#include "walking/study/walk_sweep.h"

namespace tricontact::walking::walking_studies_test {
namespace {

constexpr Kappas set_b{2, 1.2, 0.5, 1e-4, 0.68, 1e-4, 0.42, 1.18};

std::vector<Walk> walks_of(const std::vector<WalkCase>& cases) {
    return walks_side_by_side(cases, {.tail = 1, .interval = 0.1});
}

/// 40 x 40 machines over kappa8 in [0, 2] and mu in [0.1, 2], T = 4000, tilting beyond |phi| =
/// 0.01.
WalkSweep map_of_the_thesis() {
    constexpr int n = 40;
    std::vector<WalkCase> cases;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            WalkCase& c = cases.emplace_back();
            c.machine.kappas = set_b;
            c.machine.kappas.kappa8 = 2. * i / (n - 1);
            c.machine.kappas.kappa5 = 0.1 + 1.9 * j / (n - 1);
            c.machine.tilting_angle = 0.02;
            c.time = {.step = 1e-3, .end = 4000};
        }
    const std::vector<Walk> walks = walks_of(cases);
    WalkSweep sweep{.title = {},
                    .settings = {},
                    .axes = {{"machine.kappa8", ""}, {"machine.kappa5", ""}},
                    .points = {}};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Machine& machine = cases[i].machine;
        sweep.points.push_back({.values = {machine.kappas.kappa8, machine.kappas.kappa5},
                                .machine = machine,
                                .outcome = outcome_of(cases[i], walks[i])});
    }
    return sweep;
}

TEST(WalkingStudies, RegionsOfTheMap) {
    const WalkSweep sweep = map_of_the_thesis();
    const auto groups = groups_of(sweep);
    const auto grid = grid_of(sweep, groups);
    ASSERT_TRUE(grid);
    EXPECT_GE(tilting_agreement(*grid).share(), 0.99);
    const std::vector<Region> regions = regions_of(*grid, true);
    const double expected[] = {46.7, 26.5, 25.6, 10.0, 13.6, 31.2};
    ASSERT_EQ(regions.size(), std::size(expected));
    for (std::size_t i = 0; i < regions.size(); ++i) {
        // One point. Strong reduction is where chaotic transients end or do not by the middle of
        // the run: mu_e of a cell there repeats to 0.13 (90th percentile), so that some 80 cells
        // are on either side of 0.5 by chance: two deviations of their number are 1 % of the map.
        const double tolerance = regions[i].name == "strong reduction" ? 2 : 1;
        EXPECT_NEAR(100 * regions[i].share, expected[i], tolerance) << regions[i].name;
    }
}

}  // namespace
}  // namespace tricontact::walking::walking_studies_test

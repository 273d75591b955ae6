#include "walking/study/walk_sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/document_csv.h"
#include "tests/unit/walking/sets.h"
#include "walking/report/walk_sweep_document.h"
#include "walking/study/walk_factorial.h"

namespace tricontact::walking::walk_sweep_test {
namespace {

WalkSweep::Point point(std::vector<report::Cell> values, const Kappas& kappas, Regime regime,
                       double friction) {
    WalkOutcome outcome;
    outcome.result = {.regime = regime,
                      .mu_e = friction,
                      .mu_e_error = 0.01,
                      .z_min_ratio = friction < 0.5 ? -1. : 1.,
                      .z_max_ratio = 1,
                      .spots = {{0.4, -0.7}, {0.5, -0.6}}};
    outcome.second_half = {friction, outcome.result.z_min_ratio, 1};
    return {.values = std::move(values), .machine = {.kappas = kappas}, .outcome = outcome};
}

/// kappa8 from 0 to 0.9 by mu from 0 to 1.9: tilts above mu_c, else mu_e is 1 - kappa8.
WalkSweep map() {
    WalkSweep sweep{.title = "Map",
                    .settings = {},
                    .axes = {{"machine.kappa8", ""}, {"machine.kappa5", ""}},
                    .points = {}};
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 20; ++j) {
            Kappas kappas = walking::set_b();
            kappas.kappa8 = 0.1 * i;
            kappas.kappa5 = 0.1 * j;
            const bool tilts = kappas.kappa5 > critical_friction(kappas);
            sweep.points.push_back(point({kappas.kappa8, kappas.kappa5}, kappas,
                                         tilts ? Regime::tilting : Regime::chaotic,
                                         1 - kappas.kappa8));
        }
    return sweep;
}

TEST(WalkSweep, AMapHasRegions) {
    const WalkSweep sweep = map();
    const auto groups = groups_of(sweep);
    const auto grid = grid_of(sweep, groups);
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->x.size(), 10u);
    EXPECT_EQ(grid->y.size(), 20u);
    EXPECT_EQ(tilting_agreement(*grid).n_agreeing, 200);
    int n_tilting = 0, n_weak = 0;
    for (const auto& p : sweep.points) {
        const bool tilts = p.outcome->result.regime == Regime::tilting;
        n_tilting += tilts;
        n_weak += !tilts && p.outcome->result.mu_e < 0.95;
    }
    for (const bool second_half : {false, true}) {
        const auto regions = regions_of(*grid, second_half);
        EXPECT_DOUBLE_EQ(regions[0].share, n_tilting / 200.);
        EXPECT_DOUBLE_EQ(regions[2].share, n_weak / 200.);
    }
}

/// A half-plane's share of grids laid anywhere stays within the error in 95 % of them.
TEST(WalkSweep, GridErrorCoversTheAreaOfARegion) {
    constexpr int n = 20, n_grids = 200;
    int n_held = 0;
    for (int g = 0; g < n_grids; ++g) {
        const double shift = std::fmod(0.618034 * g, 1.), lift = std::fmod(0.754878 * g, 1.);
        WalkSweep sweep{.title = "Half-plane",
                        .settings = {},
                        .axes = {{"machine.kappa8", ""}, {"machine.kappa5", ""}},
                        .points = {}};
        // y < 3 + 0.6180 x in units of cells: its area over the square is a closed form.
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const bool inside = j + lift < 3 + 0.618034 * (i + shift);
                sweep.points.push_back(point({double(i), double(j)}, walking::set_b(),
                                             inside ? Regime::tilting : Regime::steady, 1));
            }
        const auto groups = groups_of(sweep);
        const Region region = regions_of(*grid_of(sweep, groups), false).front();
        const double area =
            (3.5 - lift + 0.618034 * (0.5 * n + shift - 0.5)) / n;  // of the cells about them
        n_held += std::abs(region.share - area) <= region.grid_error;
    }
    EXPECT_GE(n_held, 0.95 * n_grids);
}

// A boundary along an axis, whichever, crosses each of n lines once, and an even distribution over
// a cell has the variance 1/12: 1.96 sqrt(n/12) cells.
TEST(WalkSweep, GridErrorOfABoundaryAlongAnAxis) {
    constexpr int n = 10;
    for (const bool along_y : {false, true}) {
        WalkSweep sweep{.title = "Half",
                        .settings = {},
                        .axes = {{"machine.kappa8", ""}, {"machine.kappa5", ""}},
                        .points = {}};
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                sweep.points.push_back(
                    point({double(i), double(j)}, walking::set_b(),
                          (along_y ? i : j) < 4 ? Regime::tilting : Regime::steady, 1));
        const auto groups = groups_of(sweep);
        const Region region = regions_of(*grid_of(sweep, groups), false).front();
        EXPECT_DOUBLE_EQ(region.share, 0.4);
        EXPECT_NEAR(region.grid_error, 1.95996 * std::sqrt(n / 12.) / (n * n), 1e-6);
    }
}

// Half the range of z over z_stat, at most 0.01.
TEST(WalkSweep, ZIsConstantUpToAHundredth) {
    WalkSweep sweep = map();
    for (auto& each : sweep.points) {
        const double half = std::get<double>(each.values[0]) < 0.35 ? 0.009 : 0.011;
        each.outcome->result.z_min_ratio = 1 - half;
        each.outcome->result.z_max_ratio = 1 + half;
        each.outcome->result.regime = Regime::steady;
    }
    const auto groups = groups_of(sweep);
    const Region region = regions_of(*grid_of(sweep, groups), false)[4];
    EXPECT_EQ(region.name, "constant z");
    EXPECT_DOUBLE_EQ(region.share, 0.4);
}

TEST(WalkSweep, StartsAreRepetitions) {
    WalkSweep sweep{.title = "Curves",
                    .settings = {},
                    .axes = {{"start.x", ""}, {"machine.base_velocity", "m/s"}},
                    .points = {}};
    for (const double start : {-1., 0., 1.})
        for (const double speed : {0.01, 0.02})
            sweep.points.push_back(
                point({start, speed}, walking::set_b(), Regime::chaotic, 0.5 + 0.1 * start));
    const auto groups = groups_of(sweep);
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_NEAR(groups[0].mu_e().value, 0.5, 1e-14);
    // Student's t of two degrees of freedom at 95 % is 4.3027; the deviation is 0.1.
    EXPECT_NEAR(groups[0].mu_e().error, 4.3027 * 0.1 / std::sqrt(3.), 1e-5);
    const report::Document document = walk_sweep_document(sweep);
    ASSERT_EQ(document.sections.front().id, "curves");
    const report::Figure& figure = document.sections.front().figures.front();
    EXPECT_EQ(figure.x.label, "v_0 [mm/s]");
    EXPECT_EQ(figure.curves.front().x, (std::vector<double>{10, 20}));
    EXPECT_FALSE(walk_map_of(sweep));
}

TEST(WalkSweep, AMapHasItsReportAndPage) {
    WalkSweep sweep = map();
    const report::Document document = walk_sweep_document(sweep);
    EXPECT_EQ(document.sections.front().id, "map");
    EXPECT_EQ(document.verdicts[2].standing, report::Verdict::Standing::pass);
    EXPECT_NE(report::document_html(document).find("200 runs computed"), std::string::npos);
    const auto page = walk_map_of(sweep);
    ASSERT_TRUE(page);
    EXPECT_EQ(page->cells.size(), 200u);
    sweep.points[5].outcome.reset();
    sweep.points[5].error = "lost";
    EXPECT_EQ(walk_sweep_document(sweep).verdicts.front().sentence, "1 of 200 runs failed.");
}

/// Three levels of two factors: mu_e = 0.9 + 0.01 i + 0.03 j, no interaction.
TEST(WalkSweep, ListsOfFewNumbersAreAnExperiment) {
    WalkSweep sweep{.title = "Effects",
                    .settings = {},
                    .axes = {{"machine.kappa2", ""}, {"machine.kappa3", ""}},
                    .points = {}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            sweep.points.push_back(point({1. + i, 0.5 + j}, walking::set_b(), Regime::steady,
                                         0.9 + 0.01 * i + 0.03 * j));
    const report::Document document = walk_sweep_document(sweep);
    ASSERT_EQ(document.sections.front().id, "effects");
    const report::DocumentTable& rules = document.sections.front().tables.back();
    EXPECT_EQ(rules.id, "exclusion_rules");
    EXPECT_EQ(std::get<double>(rules.rows[0][1]), 9);
    EXPECT_NEAR(std::get<double>(rules.rows[0][2]), 0.94, 1e-14);
    EXPECT_NEAR(std::get<report::WithError>(rules.rows[0][3]).value, 0.02, 1e-14);
    EXPECT_NEAR(std::get<report::WithError>(rules.rows[0][4]).value, 0.06, 1e-14);
    // Means over 0.03 j have the deviation 0.03, and 4.30265 is Student's t of two degrees of
    // freedom; independent errors add in squares.
    EXPECT_NEAR(std::get<report::WithError>(rules.rows[0][3]).error,
                4.30265 * 0.03 * std::sqrt(2. / 3), 1e-6);
}

/// kappa2, kappa3, kappa8 at three, four and two levels: mu_e = 0.8 and a little scatter, 0.1 more
/// at one pair of levels of the first two.
WalkSweep unequal_levels(int special_i, int special_j) {
    WalkSweep sweep{
        .title = "Effects",
        .settings = {},
        .axes = {{"machine.kappa2", ""}, {"machine.kappa3", ""}, {"machine.kappa8", ""}},
        .points = {}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < 2; ++k) {
                const double special = i == special_i && j == special_j ? 0.1 : 0;
                sweep.points.push_back(point({1. + i, 2. + j, 7. + k}, walking::set_b(),
                                             Regime::steady,
                                             0.8 + special + 1e-4 * ((7 * i + 5 * j + 3 * k) % 4)));
            }
    return sweep;
}

TEST(WalkSweep, RunsStandAtTheirLevels) {
    const WalkSweep sweep = unequal_levels(0, 3);
    const auto groups = groups_of(sweep);
    const auto factorial = factorial_of(sweep, groups, machine_axes(sweep));
    ASSERT_TRUE(factorial);
    const FactorialDesign design = factorial->design(
        groups, exclusion_rules().front(), [](const WalkOutcome& o) { return o.result.mu_e; });
    for (std::size_t combination = 0; combination < design.response.size(); ++combination) {
        const bool special = design.level(combination, 0) == 0 && design.level(combination, 1) == 3;
        EXPECT_NEAR(design.response[combination], special ? 0.9 : 0.8, 4e-4) << combination;
    }
}

// A departure at one pair of levels has its largest effect there: (1 - 1/3)(1 - 1/4) of it.
TEST(WalkSweep, TheLargestEffectOfAPairIsNamedByItsLevels) {
    const report::Document document = walk_sweep_document(unequal_levels(0, 3));
    for (const report::DocumentTable& table : document.sections.front().tables) {
        if (table.id != "interactions_friction") continue;
        EXPECT_EQ(std::get<std::string>(table.rows[0][0]), "κ_2 × κ_3");
        EXPECT_EQ(std::get<std::string>(table.rows[0][1]), "1, 5");
        EXPECT_NEAR(std::get<report::WithError>(table.rows[0][2]).value, 0.1 * 2 / 3 * 3 / 4, 1e-3);
        return;
    }
    FAIL() << "no table of pairs";
}

TEST(WalkSweep, CountsRunsAndThoseThatTilt) {
    WalkSweep sweep{.title = "Curves",
                    .settings = {},
                    .axes = {{"start.x", ""}, {"machine.kappa8", ""}},
                    .points = {}};
    for (int start = 0; start < 3; ++start)
        for (const double kappa8 : {0.1, 0.2})
            sweep.points.push_back(point({double(start), kappa8}, walking::set_b(),
                                         start == 0 ? Regime::tilting : Regime::chaotic, 0.5));
    const report::Document document = walk_sweep_document(sweep);
    const report::DocumentTable& groups = document.sections.front().tables.front();
    ASSERT_EQ(groups.columns.size(), 4u);
    EXPECT_EQ(groups.columns[2].heading, "runs");
    EXPECT_EQ(std::get<double>(groups.rows[0][2]), 3);
    EXPECT_EQ(groups.columns[3].heading, "tilting");
    EXPECT_EQ(std::get<double>(groups.rows[0][3]), 1);
}

// Of two starts that disagree nothing is told; of three the two that stand.
TEST(WalkSweep, AMachineTiltsWhereHalfOfItsStartsDo) {
    for (const int n_starts : {2, 3}) {
        WalkSweep sweep{.title = "Starts",
                        .settings = {},
                        .axes = {{"start.x", ""}, {"machine.kappa8", ""}},
                        .points = {}};
        for (int start = 0; start < n_starts; ++start)
            sweep.points.push_back(point({double(start), 0.1}, walking::set_b(),
                                         start == 0 ? Regime::tilting : Regime::chaotic, 0.5));
        const auto groups = groups_of(sweep);
        EXPECT_EQ(groups.front().tilts(), n_starts == 2);
        EXPECT_EQ(std::isnan(groups.front().mu_e().value), n_starts == 2);
    }
}

// Of four runs one is on its cycle at 500, two more at 1000, one never.
TEST(WalkSweep, ArrivalsCountFromTheTimeTheyHappen) {
    WalkSweep sweep{.title = "Starts", .settings = {}, .axes = {{"start.x", ""}}, .points = {}};
    for (const double time : {500., 1000., 1000., 0.}) {
        WalkSweep::Point each = point({double(sweep.points.size())}, walking::set_b(),
                                      time > 0 ? Regime::limit_cycle : Regime::chaotic, 0.5);
        each.outcome->result.transient = time;
        each.outcome->result.period = 4;
        sweep.points.push_back(each);
    }
    const report::Document document = walk_sweep_document(sweep);
    const report::DocumentTable& arrivals = document.sections.front().tables.front();
    EXPECT_EQ(std::get<double>(arrivals.rows[0][1]), 1);  // by 500
    EXPECT_EQ(std::get<double>(arrivals.rows[1][1]), 3);  // by 1000
    EXPECT_EQ(std::get<double>(arrivals.rows[8][1]), 3);
}

/// Arrivals at equal parts of an exponential law of mean life 1000, those after 3000 not awaited.
TEST(WalkSweep, StartsTellHowLongTransientsLive) {
    WalkSweep sweep{.title = "Starts", .settings = {}, .axes = {{"start.x", ""}}, .points = {}};
    constexpr int n = 1000;
    for (int i = 0; i < n; ++i) {
        const double time = -1000 * std::log((i + 0.5) / n);
        WalkSweep::Point each = point({double(i)}, walking::set_b(), Regime::chaotic, 0.5);
        each.outcome->result.transient = 1000;
        each.outcome->result.observed = 2000;
        if (time < 3000) {
            each.outcome->result.regime = Regime::limit_cycle;
            each.outcome->result.transient = time;
            each.outcome->result.period = 4;
        }
        sweep.points.push_back(each);
    }
    const report::Document document = walk_sweep_document(sweep);
    const report::DocumentTable& arrivals = document.sections.front().tables.front();
    // 1 - exp(-1/2) of the runs by 500: 39.3 %; whole runs.
    EXPECT_NEAR(std::get<report::WithError>(arrivals.rows[0][2]).value, 39.3, 0.1);
    // Maximum likelihood with censoring: 1000, within the rounding of a thousand parts; error
    // 1.96 over the root of the 950 ends.
    EXPECT_NE(document.verdicts.back().sentence.find("mean life of the transient is 1000 ± 60"),
              std::string::npos)
        << document.verdicts.back().sentence;
}

}  // namespace
}  // namespace tricontact::walking::walk_sweep_test

#include "walking/report/map_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/page_templates.h"
#include "tests/unit/walking/sets.h"

namespace tricontact::walking::map_page_test {
namespace {

WalkOutcome walking(double mu_e, float force) {
    WalkOutcome cell{.result = {.regime = Regime::limit_cycle,
                                .mu_e = mu_e,
                                .mu_e_error = 0.0005,
                                .period = 4.2930,
                                .z_min_ratio = -0.4289,
                                .z_max_ratio = 2.3549,
                                .spots = {{0.4267, -0.759}, {0.4929, -0.727}},
                                .transient = 1449,
                                .transient_over = true}};
    cell.samples = {.interval = 0.1,
                    .displacement = {-1e-4f, 0},
                    .z = {0, 5e-5f},
                    .phi = {0, 1e-5f},
                    .spring_force = {force, 2 * force}};
    return cell;
}

WalkOutcome fallen() {
    return {.result = {.regime = Regime::tilting, .tilting_time = 321}};
}

WalkMap map() {
    return {.title = "Set B <i>",
            .machine = {.kappas = walking::set_b()},
            .kappa8 = {0, 1},
            .friction = {0.5, 2},
            .cells = {walking(0.9, 1e-5f), walking(0.0440, 1e-5f), walking(0.7, 1e-5f), fallen()},
            .settings = {{"κ_1", "2"}},
            .files = {{"all points", "results.csv"}},
            .command = "tricontact sweep \"map.toml\"",
            .version = "1.2.3"};
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

TEST(MapPage, NeedsNoNetworkAndIsTheSameEachTime) {
    const std::string page = map_page(map());
    EXPECT_EQ(page, map_page(map()));
    EXPECT_TRUE(contains(page, report::chart_library()));
    EXPECT_TRUE(contains(page, "<title>Set B &lt;i&gt; – Tricontact</title>"));
    EXPECT_TRUE(contains(page, R"(<a href="results.csv">all points</a>)"));
    EXPECT_TRUE(contains(page, "tricontact sweep &quot;map.toml&quot;"));
    EXPECT_TRUE(contains(page, R"(id="slider_y" min="0" max="1")"));
}

TEST(MapJson, BeginsAtTheLeastFriction) {
    EXPECT_EQ(map_json(map())["start"], 1);
    WalkMap other = map();
    other.cells.front() = fallen();  // has no friction to compare
    EXPECT_EQ(map_json(other)["start"], 1);
    other = map();
    other.cells[1].result.transient_over = false;  // may come to any friction yet
    EXPECT_EQ(map_json(other)["start"], 2);
}

TEST(MapJson, BlanksMachinesThatFellOver) {
    const auto json = map_json(map());
    const auto& friction = json["quantities"][0];
    EXPECT_EQ(friction["values"][1], 0.0440);
    EXPECT_TRUE(friction["values"][3].is_null());
    EXPECT_EQ(friction["low"], 0.0440);
    EXPECT_EQ(friction["high"], 0.9);
    const auto& motions = json["quantities"].back();
    EXPECT_EQ(motions["words"][motions["values"][3].get<int>()], "falls over");
    EXPECT_EQ(json["cells"][3]["readings"][0], "falls over at t = 321.0");
    EXPECT_TRUE(json["cells"][3]["samples"].empty());
    EXPECT_TRUE(json["cells"][3]["mean"].is_null());
}

// Colours end at a jump of three static displacements, whatever the highest one is.
TEST(MapJson, HighJumpsDoNotStretchTheColours) {
    WalkMap high = map();
    high.cells[1].result.z_min_ratio = -200;
    const auto json = map_json(high);
    const auto& heights = json["quantities"][1];
    EXPECT_EQ(heights["values"][1], -200);
    EXPECT_EQ(heights["low"], -3);
    EXPECT_EQ(heights["high"], -0.4289);
}

TEST(MapJson, DoesNotCallChaosWhatIsNotOver) {
    WalkMap young = map();
    young.cells[0].result.transient_over = false;
    const auto json = map_json(young);
    const auto& motions = json["quantities"].back();
    EXPECT_EQ(motions["words"][motions["values"][0].get<int>()], "not settled yet");
    EXPECT_EQ(motions["words"][motions["values"][1].get<int>()], "walks in a limit cycle");
    EXPECT_EQ(json["cells"][0]["readings"][0], "not settled yet");
}

TEST(MapJson, ReadsNumbersWithTheirErrors) {
    const auto json = map_json(map());
    EXPECT_EQ(json["cells"][1]["readings"],
              (std::vector<std::string>{"walks in a limit cycle", "0.0440 ± 0.0005", "4.2930",
                                        "−0.4289, 2.355", "0.427, 0.493", "−0.759, −0.727",
                                        "until t = 1449", "1.000"}));
}

// Set B has mu_c = 1/(kappa3 (1 + kappa8)) = 2 and 1 at kappa8 = 0 and 1: Wetter (2016),
// eq. 4.2.13. The prism presses sqrt(2) times as hard on its flanks.
TEST(MapJson, DrawsTheCriticalFriction) {
    const auto limit = map_json(map())["limit"]["y"];
    EXPECT_DOUBLE_EQ(limit.front(), 2);
    EXPECT_DOUBLE_EQ(limit.back(), 1);
    WalkMap prism = map();
    prism.machine.model = Machine::Model::prism;
    EXPECT_DOUBLE_EQ(map_json(prism)["limit"]["y"].back(), 1 / std::sqrt(2.));
    WalkMap spots = map();  // tilts over the one in front
    spots.machine.model = Machine::Model::spots;
    spots.machine.spots = {{.position = -1}, {.position = 0.5}};
    EXPECT_DOUBLE_EQ(map_json(spots)["limit"]["y"].back(), 0.5);
}

// f_s/(mu kappa4) of 1e-5 and 2e-5 at mu = 0.5 and kappa4 = 1e-4: 0.2 and 0.4; z_stat of set B is
// 1e-4/2.4.
TEST(MapJson, NormalisesMotions) {
    const auto samples = map_json(map())["cells"][1]["samples"];
    constexpr float rounding = 1e-6f;  // of single precision
    EXPECT_NEAR(samples[0][0], -1, rounding);
    EXPECT_NEAR(samples[1][0], 0.6, rounding);
    EXPECT_NEAR(samples[2][0], 0.2, rounding);
    EXPECT_NEAR(samples[3][0], 0.3, rounding);
    EXPECT_NEAR(samples[3][1].get<double>() * 32767, 0.1, rounding);
}

}  // namespace
}  // namespace tricontact::walking::map_page_test

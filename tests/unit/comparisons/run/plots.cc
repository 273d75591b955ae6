#include "comparisons/run/plots.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <set>
#include <system_error>
#include <thread>

#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::plots_test {
namespace {

using synthetic::Options;

struct PlotCase {
    std::string name;
    Options options;
    std::string only = "";           ///< one model, or both
    std::set<std::string> expected;  ///< names of the plots
};

std::ostream& operator<<(std::ostream& out, const PlotCase& c) {
    return out << c.name;
}

const std::set<std::string> all{
    "shift",      "shift_ratio", "dissipation",          "traction_x",
    "traction_y", "zones_bem",   "traction_surface_bem", "displacement_surface_bem"};
const std::set<std::string> lines{"shift", "shift_ratio", "dissipation", "traction_x",
                                  "traction_y"};

std::set<std::string> without(std::set<std::string> names, const std::string& name) {
    names.erase(name);
    return names;
}

class Plots : public testing::TestWithParam<PlotCase> {
  protected:
    Histories histories() const {
        Histories result = synthetic::two_models(GetParam().options);
        std::erase_if(result, [](const contact::History& history) {
            return !GetParam().only.empty() && history.model != GetParam().only;
        });
        return result;
    }
};

TEST_P(Plots, AreDrawnInBothFormats) {
    const auto plots = make_plots(synthetic::unit_case(GetParam().options), histories());
    std::set<std::string> names;
    for (const Plot& plot : plots) {
        names.insert(plot.name);
        EXPECT_FALSE(plot.title.empty());
        EXPECT_FALSE(plot.caption.empty());
        EXPECT_EQ(plot.picture.script.find("nan "), std::string::npos) << plot.name;
    }
    EXPECT_EQ(names, GetParam().expected);

    const auto drawings = draw_all(plots);
    ASSERT_EQ(drawings.size(), plots.size());
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const auto& [svg, png] = drawings[i];
        EXPECT_TRUE(svg.starts_with("<?xml")) << plots[i].name;
        EXPECT_NE(svg.find("</svg>"), std::string::npos) << plots[i].name;
        // Something is drawn beyond the empty canvas.
        EXPECT_GT(std::count(svg.begin(), svg.end(), '\n'), 60) << plots[i].name;
        EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n")) << plots[i].name;
        EXPECT_NE(png.find("IEND"), std::string::npos) << plots[i].name;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Plots,
    testing::Values(PlotCase{"shakedown", {}, "", all},
                    PlotCase{"ratcheting", {.f = 0.8, .w = 0.5}, "", all},
                    PlotCase{"mdr_only", {}, "mdr", lines}, PlotCase{"bem_only", {}, "bem", all},
                    PlotCase{"static",
                             {.rolling = false},
                             "",
                             without(without(without(all, "shift"), "shift_ratio"), "dissipation")},
                    PlotCase{"one_period", {.periods = 1}, "", all},
                    // W0 vanishes with f_T: there is no ratio to draw.
                    PlotCase{"no_tangential_force", {.f = 0}, "", without(all, "dissipation")},
                    PlotCase{"no_amplitude", {.w = 0}, "", all},
                    PlotCase{"largest_amplitude", {.f = 0.3, .w = 1}, "", all},
                    PlotCase{"oblique", {.angle = std::numbers::pi / 4}, "", all},
                    PlotCase{"perpendicular", {.angle = std::numbers::pi / 2}, "", all},
                    PlotCase{"many_periods", {.periods = 500}, "", all},
                    PlotCase{"even_grid", {.n_x = 40, .n_y = 30}, "", all},
                    PlotCase{"many_points", {.n_x = 320, .n_y = 320, .springs = 20001}, "", all}),
    [](const auto& tested) { return tested.param.name; });

// Where the system gives no further thread - here none whose stack is larger than all addresses -
// one draws them all.
TEST(PlotDrawing, OneThreadDrawsWhatMoreWouldDraw) {
    const Options options{.rolling = false};
    const auto plots = make_plots(synthetic::unit_case(options), synthetic::two_models(options));
    const auto due = draw_all(plots);
    pthread_attr_t usual, none;
    ASSERT_EQ(pthread_getattr_default_np(&usual), 0);
    ASSERT_EQ(pthread_attr_init(&none), 0);
    ASSERT_EQ(pthread_attr_setstacksize(&none, std::size_t{1} << 60), 0);
    ASSERT_EQ(pthread_setattr_default_np(&none), 0);
    EXPECT_THROW(std::thread([] {}).join(), std::system_error);
    const auto drawings = draw_all(plots);
    ASSERT_EQ(pthread_setattr_default_np(&usual), 0);
    ASSERT_EQ(drawings.size(), due.size());
    for (std::size_t i = 0; i < due.size(); ++i) {
        EXPECT_EQ(drawings[i].svg, due[i].svg) << plots[i].name;
        EXPECT_EQ(drawings[i].png, due[i].png) << plots[i].name;
    }
}

TEST(PlotData, AreThinnedForThePicture) {
    const Options options{.periods = 500, .n_x = 320, .n_y = 320, .springs = 20001};
    for (const Plot& plot :
         make_plots(synthetic::unit_case(options), synthetic::two_models(options)))
        // A picture of 640 pixels needs no more; 100 k points would take megabytes.
        EXPECT_LT(plot.picture.script.size(), 300000u) << plot.name;
}

TEST(PlotData, TheoryIsDrawnOnlyWhereItHolds) {
    const auto script_of = [](const contact::Case& c, const Options& options) {
        return shift_plots(c, synthetic::two_models(options)).back().picture.script;
    };
    const Options settles{.f = 0.3, .w = 0.2}, ratchets{.f = 0.8, .w = 0.5};
    contact::Case c = synthetic::unit_case(settles);
    EXPECT_NE(script_of(c, settles).find("MDR closed form"), std::string::npos);
    c.load.tangential_amplitude_ratio = 0.1;
    EXPECT_EQ(script_of(c, settles).find("MDR closed form"), std::string::npos);
    EXPECT_EQ(script_of(synthetic::unit_case(ratchets), ratchets).find("MDR closed form"),
              std::string::npos);
}

TEST(PlotData, ChosenInstantsOfTheMaps) {
    const Options options{.periods = 12};
    const auto script = zone_maps(synthetic::unit_case(options), synthetic::two_models(options))
                            .front()
                            .picture.script;
    // The synthetic run keeps the first and the last period only: 2.75 is replaced by 11.75.
    std::size_t at = 0;
    for (const char* title : {"'n = 0'", "'n = 0.25'", "'n = 11.75'", "'n = 12'"}) {
        at = script.find(title, at);
        EXPECT_NE(at, std::string::npos) << title;
    }
}

TEST(PlotData, TractionsAgainstTheLoadStayInThePicture) {
    const Options options{.rolling = false};
    auto histories = synthetic::two_models(options);
    for (auto& snapshot : histories[1].snapshots)
        for (double& t : snapshot.surface.tangential_traction_x) t -= 0.2 * 2 / std::numbers::pi;
    const contact::Case c = synthetic::unit_case(options);
    // mu p0 = 2/pi: -0.2 at the edge, with 4 % of margin; strips 0.06 below the curves.
    EXPECT_NE(surface_plots(c, histories)[0].picture.script.find("set zrange [-0.208:"),
              std::string::npos);
    EXPECT_NE(traction_plots(c, histories)[0].picture.script.find("set yrange [-0.48:"),
              std::string::npos);
}

TEST(PlotData, ErrorsOfGnuplotReachTheCaller) {
    Plot broken{"broken", "t", "c", {320, 200, "plot nonsense(x)"}};
    EXPECT_THROW(draw_all({broken}), report::GnuplotError);
}

TEST(PlotData, SameHistoriesSameBytes) {
    const auto draw_twice = [] {
        return draw_all(make_plots(synthetic::unit_case(), synthetic::two_models()));
    };
    const auto first = draw_twice(), second = draw_twice();
    ASSERT_EQ(first.size(), all.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].svg, second[i].svg);
        EXPECT_EQ(first[i].png, second[i].png);
    }
}

}  // namespace
}  // namespace tricontact::comparisons::plots_test

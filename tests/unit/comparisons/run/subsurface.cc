#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/summary.h"
#include "comparisons/run/plots.h"
#include "comparisons/run/report_tables.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::subsurface_test {
namespace {

/// Of the unit case, a = 1, p0 = 2/pi: uniaxial stress that falls with the depth.
contact::Subsurface inside() {
    contact::Subsurface s;
    s.phase = 12;
    s.peak_von_mises = .4;
    s.peak_position = {.1, 0, -.5};
    for (int i = -5; i <= 5; ++i) s.x.push_back(.5 * i);
    for (int k = -4; k <= 0; ++k) s.z.push_back(k);
    for (int k = -4; k <= 0; ++k)
        for (int i = -5; i <= 5; ++i) s.stress.push_back({0, 0, .1 * (k - 1), 0, 0, 0});
    return s;
}

std::vector<contact::History> with_inside(const contact::Subsurface& s) {
    auto histories = synthetic::two_models();
    histories.back().subsurface = s;
    return histories;
}

TEST(ComparisonsSubsurface, SummarySaysWhereTheStressPeaks) {
    const auto c = synthetic::unit_case();
    std::vector<Results> summaries;
    for (const auto& history : with_inside(inside())) summaries.emplace_back(c, history);
    const auto json = nlohmann::json::parse(summary_json("1", nullptr, summaries));
    EXPECT_TRUE(json["models"]["mdr"]["subsurface"].is_null());
    const auto& s = json["models"]["bem"]["subsurface"];
    EXPECT_EQ(s["phase"].get<double>(), 12);
    EXPECT_EQ(s["peak_von_mises_Pa"].get<double>(), .4);
    EXPECT_NEAR(s["peak_von_mises_ratio"].get<double>(), .2 * std::numbers::pi, 1e-15);
    EXPECT_EQ(s["peak_position_m"].get<std::vector<double>>(), (std::vector{.1, 0., -.5}));

    const Table table = results_table(c, summaries);
    const auto group = std::find_if(table.groups.begin(), table.groups.end(), [](const auto& g) {
        return g.title == "Inside the substrate";
    });
    ASSERT_NE(group, table.groups.end());
    EXPECT_EQ(group->rows[1].cells[0], "–");
    EXPECT_EQ(group->rows[1].cells[1], "0.6283");
    EXPECT_EQ(group->rows[3].cells[1], "−0.5000");
}

TEST(ComparisonsSubsurface, FiguresShowTheSectionAndTheAxis) {
    const auto c = synthetic::unit_case();
    EXPECT_TRUE(subsurface_plots(c, synthetic::two_models()).empty());
    const auto plots = subsurface_plots(c, with_inside(inside()));
    ASSERT_EQ(plots.size(), 2U);
    EXPECT_EQ(plots[0].name, "von_mises_bem");
    EXPECT_NE(plots[0].caption.find("0.628 p_0"), std::string::npos) << plots[0].caption;
    // 2 a to either side, 3 a deep, in a and p0.
    EXPECT_NE(plots[0].picture.script.find("\n2 -3 0.62832\n"), std::string::npos);
    EXPECT_EQ(plots[0].picture.script.find("\n2.5 "), std::string::npos);
    EXPECT_EQ(plots[1].name, "axis_stress");
    EXPECT_NE(plots[1].picture.script.find("\n3 0.628319 0.628319 \n"), std::string::npos);
    EXPECT_NE(plots[1].picture.script.find("Hertz"), std::string::npos);
    for (const Drawing& drawing : draw_all(plots)) {
        EXPECT_GT(std::count(drawing.svg.begin(), drawing.svg.end(), '\n'), 60);
        EXPECT_NE(drawing.png.find("IEND"), std::string::npos);
    }
}

TEST(ComparisonsSubsurface, PointsThatAreNoGridAreNotDrawn) {
    contact::Subsurface s = inside();
    s.x.clear();
    s.z.clear();
    s.stress.clear();
    EXPECT_TRUE(subsurface_plots(synthetic::unit_case(), with_inside(s)).empty());
}

}  // namespace
}  // namespace tricontact::comparisons::subsurface_test

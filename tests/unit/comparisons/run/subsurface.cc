#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "comparisons/quantities/results.h"
#include "comparisons/run/figures.h"
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
    EXPECT_EQ(s["peak_position_m"].get<std::vector<double>>(),
              (std::vector{.1, 0., .5}));  // z into the substrate

    const auto tables = results_tables(c, summaries);
    const auto table = std::ranges::find(tables, "inside", &report::DocumentTable::id);
    ASSERT_NE(table, tables.end());
    EXPECT_TRUE(std::isnan(std::get<double>(table->rows[1][2])));
    EXPECT_NEAR(std::get<double>(table->rows[1][3]), .2 * std::numbers::pi, 1e-12);
    EXPECT_EQ(std::get<double>(table->rows[3][3]), .5);
}

TEST(ComparisonsSubsurface, FiguresShowTheSectionAndTheAxis) {
    const auto c = synthetic::unit_case();
    EXPECT_TRUE(subsurface_figures(c, synthetic::two_models()).empty());
    const auto figures = subsurface_figures(c, with_inside(inside()));
    ASSERT_EQ(figures.size(), 2U);
    EXPECT_EQ(figures[0].id, "von_mises_bem");
    EXPECT_NE(figures[0].caption.find("0.628 p_0"), std::string::npos) << figures[0].caption;
    // 2 a to either side, 3 a deep, in a and p0.
    const report::ContourMap& map = figures[0].map.value();
    EXPECT_EQ(map.x.front(), -2);
    EXPECT_EQ(map.x.back(), 2);
    EXPECT_EQ(map.y.front(), -3);
    EXPECT_EQ(map.y.back(), 0);
    EXPECT_NEAR(map.values.front(), .2 * std::numbers::pi, 1e-12);
    EXPECT_EQ(figures[1].id, "axis_stress");
    EXPECT_EQ(figures[1].curves[0].name, "von Mises, Hertz");
    const report::Curve& pressure = figures[1].curves.back();
    EXPECT_EQ(pressure.name, "−σ_z, BEM");
    EXPECT_EQ(pressure.y.back(), 3);
    EXPECT_NEAR(pressure.x.back(), .2 * std::numbers::pi, 1e-12);
}

TEST(ComparisonsSubsurface, PointsThatAreNoGridAreNotDrawn) {
    contact::Subsurface s = inside();
    s.x.clear();
    s.z.clear();
    s.stress.clear();
    EXPECT_TRUE(subsurface_figures(synthetic::unit_case(), with_inside(s)).empty());
}

}  // namespace
}  // namespace tricontact::comparisons::subsurface_test

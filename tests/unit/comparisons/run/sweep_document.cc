#include "comparisons/run/sweep_document.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/document_csv.h"

namespace tricontact::comparisons::sweep_document_test {
namespace {

/// Two models over amplitude and thickness; the shift is 10 times the amplitude plus the thickness
/// in metres, thick layers ratchet.
Sweep sweep() {
    Sweep result{.title = "Two by two",
                 .settings = {{"case", "a.toml"}},
                 .axes = {{"rolling.amplitude", "m"}, {"substrate.thickness", "m", true}},
                 .points = {}};
    for (const double amplitude : {1e-3, 2e-3})
        for (const double thickness : {0.004, 0.008})
            for (const char* model : {"mdr", "bem-layer"}) {
                const bool thick = thickness > 0.005;
                Sweep::Point& point = result.points.emplace_back();
                point.values = {amplitude, thickness};
                point.model = model;
                using namespace quantities;
                point.results.set(quantities::state,
                                  thick ? contact::State::ratcheting : contact::State::shakedown);
                point.results.set(static_shift_ratio, 0.1);
                if (!thick) point.results.set(settled_shift_ratio, 10 * amplitude + thickness);
                point.results.set(shift_increment_ratio, thick ? amplitude : 0);
            }
    return result;
}

TEST(SweepDocument, CountsWhatBecameOfThePoints) {
    Sweep some = sweep();
    report::Document document = sweep_document(some);
    ASSERT_EQ(document.verdicts.size(), 3u);
    EXPECT_EQ(document.verdicts[0].standing, report::Verdict::Standing::pass);
    EXPECT_EQ(document.verdicts[0].sentence, "8 points computed, none failed.");
    EXPECT_EQ(document.verdicts[2].sentence,
              "BEM layer: of 4 rolling points, 2 shake down, 2 ratchet, 0 stay undecided.");
    some.points[1].error = "no convergence";
    document = sweep_document(some);
    EXPECT_EQ(document.verdicts[0].standing, report::Verdict::Standing::fail);
    EXPECT_EQ(document.verdicts[0].sentence, "1 of 8 points failed.");
    const report::DocumentTable& failed = document.sections.back().tables.back();
    EXPECT_EQ(report::table_csv(failed),
              "model,rolling.amplitude [mm],substrate.thickness [mm],error\n"
              "BEM layer,1,4,no convergence\n");
}

TEST(SweepDocument, LinesJoinPointsThatDifferInOneKey) {
    const auto sections = shift_sections(sweep(), scales_of(sweep()));
    ASSERT_EQ(sections.size(), 3u);
    EXPECT_EQ(sections[1].heading, "Settled shift u_sd");
    const report::Figure& over_amplitude = sections[1].figures[0];
    EXPECT_EQ(over_amplitude.id, "settled_shift_ratio_1");
    EXPECT_EQ(over_amplitude.x.label, "rolling.amplitude [mm]");
    EXPECT_FALSE(over_amplitude.x.logarithmic);
    EXPECT_TRUE(sections[1].figures[1].x.logarithmic);
    // A line for each model and thickness; the thick layer does not settle.
    ASSERT_EQ(over_amplitude.curves.size(), 4u);
    const report::Curve &thin = over_amplitude.curves[0], &thick = over_amplitude.curves[1];
    EXPECT_EQ(thin.kind, report::Curve::Kind::line_and_points);
    EXPECT_EQ(thin.name, "MDR");
    EXPECT_EQ(thin.detail, "substrate.thickness [mm] = 4");
    EXPECT_EQ(thin.x, (std::vector<double>{1, 2}));
    EXPECT_DOUBLE_EQ(thin.y[0], 0.014);
    EXPECT_DOUBLE_EQ(thin.y[1], 0.024);
    EXPECT_EQ(thick.detail, "substrate.thickness [mm] = 8");
    for (const double y : thick.y) EXPECT_TRUE(std::isnan(y));
    EXPECT_DOUBLE_EQ(sections[2].figures[0].curves[3].y[1], 2e-3);  // increment, thick layer
    // The data name each line; the words say which is which.
    EXPECT_NE(report::figure_csv(over_amplitude).find("MDR, substrate.thickness [mm] = 8: u_sd"),
              std::string::npos);
    EXPECT_NE(sections[1].figures[1].caption.find(
                  "One line per rolling.amplitude [mm], 1 (bottom) to 2 (top)."),
              std::string::npos)
        << sections[1].figures[1].caption;
}

// The static shift is the same everywhere: the report opens with the settled one, over the
// amplitude, which moves it most (24 to 14 mm; the thickness has one value that settles).
TEST(SweepDocument, OpensWithTheKeyThatMovesTheResultMost) {
    Sweep some = sweep();
    report::Document document = sweep_document(some);
    ASSERT_TRUE(document.figure);
    EXPECT_EQ(document.figure->id, "settled_shift_ratio_1");
    for (const report::DocumentSection& section : document.sections)
        for (const report::Figure& figure : section.figures)
            EXPECT_NE(figure.id, document.figure->id);
    // The other way round: now the thickness does.
    for (Sweep::Point& point : some.points)
        point.results.set(
            quantities::settled_shift_ratio,
            std::get<double>(point.values[0]) + 100 * std::get<double>(point.values[1]));
    EXPECT_EQ(sweep_document(some).figure->id, "settled_shift_ratio_2");
}

TEST(SweepDocument, SamplesArePointsAndWordsNoAxis) {
    Sweep sample = sweep();
    sample.axes = {{"rolling.angle", "rad"}, {"load.tangential_ratio", ""}, {"substrate.base", ""}};
    for (std::size_t i = 0; i < sample.points.size(); ++i)
        sample.points[i].values = {0.1 * static_cast<double>(i),
                                   0.5 - 0.01 * static_cast<double>(i),
                                   std::string(i % 2 ? "bonded" : "sliding")};
    const auto sections = shift_sections(sample, scales_of(sample));
    ASSERT_EQ(sections[0].figures.size(), 2u);
    EXPECT_EQ(sections[0].figures[0].x.label, "rolling.angle [°]");
    EXPECT_EQ(sections[0].figures[0].curves[0].kind, report::Curve::Kind::points);
    const auto settings = sweep_document(sample).settings;
    EXPECT_EQ(settings[1].second, "0 ... 40.107 °, 8 values");
    EXPECT_EQ(settings[3].second, "bonded, sliding");
}

// Coarser levels are there for the errors of the finest one, which alone is drawn.
TEST(SweepDocument, TheFinestLevelIsDrawn) {
    Sweep levels = sweep();
    levels.levels = 2;
    for (std::size_t i = 0; i < levels.points.size(); ++i)
        levels.points[i].level = static_cast<int>(i / 2 % 2);
    const auto sections = shift_sections(levels, scales_of(levels));
    const report::Figure& figure = sections.back().figures[0];
    ASSERT_EQ(figure.curves.size(), 2u);
    EXPECT_EQ(figure.curves[1].name, "BEM layer");
    EXPECT_NE(figure.caption.find("The finest of 2 levels."), std::string::npos);
}

TEST(SweepDocument, ManyPointsStayInTheTableBeside) {
    Sweep many = sweep();
    const Sweep::Point point = many.points.front();
    many.points.resize(most_drawn, point);
    EXPECT_EQ(sweep_document(many).sections.front().figures.size(), 2u);
    many.points.push_back(point);
    const report::Document document = sweep_document(many);
    ASSERT_EQ(document.sections.size(), 1u);
    EXPECT_TRUE(document.sections[0].tables.empty());
    EXPECT_EQ(document.sections[0].paragraphs.size(), 2u);
}

// Gross slip from an amplitude of 3 um at 10 N and of 7 um at 20 N on, say: boundaries lie halfway.
TEST(SweepDocument, FrettingMapHasRegimesAndTheirBoundaries) {
    Sweep map{.title = "Map", .axes = {{"load.shift_amplitude", "m"}, {"load.normal_force", "N"}}};
    for (const double force : {10., 20.})
        for (const double amplitude : {2e-6, 4e-6, 6e-6, 8e-6}) {
            Sweep::Point& point = map.points.emplace_back();
            point.values = {amplitude, force};
            point.model = "mdr";
            point.results.set(quantities::path_regime, amplitude > (force > 15 ? 7e-6 : 3e-6)
                                                           ? SlipRegime::gross_slip
                                                           : SlipRegime::partial_slip);
        }
    const report::Document document = sweep_document(map);
    ASSERT_TRUE(document.figure);
    EXPECT_EQ(document.figure->id, "regimes_1");
    const auto& curves = document.figure->curves;
    ASSERT_EQ(curves.size(), 3u);
    EXPECT_EQ(curves[0].name, "partial-slip");
    EXPECT_EQ(curves[0].x.size(), 4u);
    EXPECT_EQ(curves[1].name, "gross-slip");
    EXPECT_EQ(curves[2].y, (std::vector<double>{10, 20}));
    EXPECT_NEAR(curves[2].x[0], 3, 1e-12);  // in um
    EXPECT_NEAR(curves[2].x[1], 7, 1e-12);
}

TEST(SweepDocument, NoPointsNoNumbers) {
    const report::Document document =
        sweep_document({.title = "Empty", .settings = {}, .axes = {{"a", "m"}}, .points = {}});
    EXPECT_EQ(document.verdicts.front().sentence, "0 points computed, none failed.");
    EXPECT_EQ(document.settings.front().second, "no values");
    EXPECT_FALSE(report::document_html(document).empty());
}

}  // namespace
}  // namespace tricontact::comparisons::sweep_document_test

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "report/chart_json.h"
#include "report/document_csv.h"
#include "report/gnuplot_figure.h"

// What gnuplot draws, read from its SVG, beside what the page draws of the same figure: series,
// points, stretches of lines, ranges, labels. PDF and PNG are other terminals of the same script.

namespace tricontact::report::drawn_figures_test {
namespace {

using json = nlohmann::ordered_json;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A sweep's figure: two loads for one model, with bars, one undefined value; a curve in two
/// stretches; a closed form.
Figure study() {
    return {.id = "study",
            .title = "Study",
            .x = {.label = "amplitude [mm]"},
            .y = {.label = "shift [µm]"},
            .curves = {{.name = "MDR",
                        .x = {2.06, 2.065, 2.07, 2.075, 2.08},
                        .y = {1, 2, 3, 4, 5},
                        .y_error = {.1, .1, nan, .2, .1},
                        .kind = Curve::Kind::line_and_points,
                        .detail = "f_T = 0.1"},
                       {.name = "MDR",
                        .x = {2.06, 2.07, 2.08},
                        .y = {5, 6, 7},
                        .kind = Curve::Kind::line_and_points,
                        .detail = "f_T = 0.3"},
                       {.name = "BEM",
                        .x = {2.06, 2.065, 2.07, 2.075, 2.08},
                        .y = {1.5, 2.5, nan, 4.5, 5.5},
                        .kind = Curve::Kind::line_and_points},
                       {.name = "exact", .x = {2.06, 2.08}, .y = {0, 8}, .theory = true}}};
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

/// As the page reads it: what is no number is null.
json page_of(const Figure& figure) {
    return json::parse(figure_json(figure).dump());
}

/// Lines without a gap among what is drawn.
std::size_t n_lines(const std::string& drawn) {
    std::size_t n = 0;
    for (auto at = drawn.find(" d='"); at != std::string::npos; at = drawn.find(" d='", at + 1))
        n += count(drawn.substr(at, drawn.find('\'', at + 4) - at), "M");
    return n;
}

/// What gnuplot has drawn of its n-th plot, from 1.
std::string plot_of(const std::string& svg, std::size_t n) {
    const auto begin = svg.find("id=\"gnuplot_plot_" + std::to_string(n) + "\"");
    if (begin == std::string::npos) return "";
    return svg.substr(begin, svg.find("</g>\n\t</g>\n", begin + 1) - begin);
}

/// Numbers of a chart that are drawn, and stretches of them without a gap.
struct Drawn {
    std::size_t points = 0, stretches = 0;
    explicit Drawn(const json& curve) {
        bool before = false;
        for (std::size_t i = 0; i < curve["x"].size(); ++i) {
            const bool now = !curve["x"][i].is_null() && !curve["y"][i].is_null();
            points += now, stretches += now && !before;
            before = now;
        }
    }
};

// Found: a missing value was no gap, so that all loads of a model were one zigzag; bars cleared the
// markers that they belong to.
TEST(DrawnFigures, CurvesAreTheSameOnPaperAndOnThePage) {
    const Figure figure = study();
    const std::string svg = draw_all({figure}).front().svg;
    const json page = page_of(figure);
    EXPECT_EQ(count(svg, "id=\"gnuplot_plot_"), page["curves"].size() + 1);  // and the bars
    EXPECT_EQ(count(svg, "color='#FFFFFF'/>"), 0u);                          // nothing is erased
    std::size_t plot = 1;
    for (const json& curve : page["curves"]) {
        if (!curve["y_error"].empty()) {
            // Each bar: its line, two heads.
            const std::size_t n_bars = std::ranges::count_if(
                curve["y_error"], [](const json& error) { return !error.is_null(); });
            EXPECT_EQ(n_lines(plot_of(svg, plot)), 3 * n_bars);
            ++plot;
        }
        const std::string drawn = plot_of(svg, plot++);
        const Drawn due(curve);
        const bool named = curve["named"];  // a sample in the key: one stretch, one marker
        EXPECT_EQ(n_lines(drawn), due.stretches + named) << curve["name"];
        if (curve["kind"] != "line") {
            EXPECT_EQ(count(drawn, "<use "), due.points + named) << curve["name"];
        }
        if (named) {
            EXPECT_EQ(count(svg, ">" + curve["name"].get<std::string>() + "<"), 2u);  // and <title>
        }
    }
    for (const char* axis : {"x", "y"})
        EXPECT_EQ(count(svg, ">" + page[axis]["label"].get<std::string>() + "<"), 1u);
}

// Found: "2.0652.072.0752.08". Numbers along x are 9 px a letter, at most; they do not touch.
TEST(DrawnFigures, NumbersAlongAnAxisStandApart) {
    Figure figure = study();
    for (const int width : {400, 640}) {
        const Picture picture = picture_of(figure, {.width = width});
        const auto at = picture.script.find("set xtics ");
        ASSERT_NE(at, std::string::npos);
        const double step = std::stod(picture.script.substr(at + 10));
        const double n = std::floor(.02 / step + 1e-9) + 1;
        EXPECT_GE(n, 2);
        EXPECT_LT(n * 9 * 5, width - 110) << step;
    }
    // Round steps, whatever the range.
    for (const double range : {3e-4, .7, 12., 9000.}) {
        figure.curves = {{.x = {0, range}, .y = {0, 1}}};
        const std::string script = picture_of(figure).script;
        const double step = std::stod(script.substr(script.find("set xtics ") + 10));
        const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
        EXPECT_LT(std::min({std::abs(digit - 1), std::abs(digit - 2), std::abs(digit - 5)}), 1e-6);
        EXPECT_GE(range / step, 2);
        EXPECT_LE(range / step, 12);
    }
}

// Found: what has no value widens no axis; gnuplot chose other ends, and 21 numbers ran together.
TEST(DrawnFigures, StepsOfAnAxisAreThoseOfWhatIsDrawn) {
    const Figure one{.curves = {{.x = {0, .1, .4}, .y = {1, nan, nan}}}};
    EXPECT_EQ(picture_of(one).script.find("set xtics "), std::string::npos);
    const Figure two{.curves = {{.x = {0, 1, 1000}, .y = {1, 2, nan}}}};
    const std::string script = picture_of(two).script;
    EXPECT_LT(std::stod(script.substr(script.find("set xtics ") + 10)), 1);
}

// Found: curves at the height 0 over a map made its bar of colours begin there.
TEST(DrawnFigures, TheColourBarIsThatOfTheValues) {
    const Figure figure{
        .id = "map",
        .x = {"x/a"},
        .y = {"y/a"},
        .curves = {{.name = "largest", .x = {11}, .y = {5.5}, .kind = Curve::Kind::points}},
        .map = ContourMap{"κ", {10, 11, 12}, {5, 6}, {1.2, 1.3, 1.4, 1.5, nan, 1.6}}};
    const json page = page_of(figure);
    double low = INFINITY, high = -INFINITY;
    for (const json& row : page["map"]["rows"])
        for (const json& value : row)
            if (!value.is_null())
                low = std::min(low, value.get<double>()),
                high = std::max(high, value.get<double>());
    const std::string script = picture_of(figure).script;
    const auto at = script.find("set cbrange [");
    ASSERT_NE(at, std::string::npos);
    std::istringstream ends(script.substr(at + 13));
    double from = 0, to = 0;
    char colon = 0;
    ends >> from >> colon >> to;
    EXPECT_DOUBLE_EQ(from, low);
    EXPECT_DOUBLE_EQ(to, high);
    const std::string svg = draw_all({figure}).front().svg;
    EXPECT_EQ(count(svg, ">0.2<") + count(svg, ">0.4<"), 0u);  // numbers beside the bar
    EXPECT_EQ(count(svg, ">1.4<"), 1u);
}

// Differences: as much room for either sign, and no line where they vanish but for rounding.
TEST(DrawnFigures, AMapAboutZeroIsEvenInBothSigns) {
    const Figure figure{.id = "map",
                        .x = {"x/a"},
                        .y = {"y/a"},
                        .map = ContourMap{.label = "difference [%]",
                                          .x = {0, 1, 2},
                                          .y = {0, 1},
                                          .values = {1e-15, -2, 8, -1e-15, 4, nan},
                                          .about_zero = true}};
    EXPECT_EQ(page_of(figure)["map"]["about_zero"], true);
    const std::string script = picture_of(figure).script;
    EXPECT_NE(script.find("set cbrange [-8:8]"), std::string::npos);
    EXPECT_NE(script.find("levels discrete -6, -2, 2, 6"), std::string::npos);
    EXPECT_EQ(script.find("auto 8"), std::string::npos);
}

// Stick and slip: the same colours, as many stretches and cells.
TEST(DrawnFigures, ZonesHaveTheirColours) {
    const Figure figure{.id = "zones",
                        .x = {.label = "x", .low = -1, .high = 1},
                        .y = {"traction"},
                        .curves = {{.name = "BEM", .x = {-1, 1}, .y = {0, 1}}},
                        .kinds = {{"stick", .8, "#465678"}, {"slip", .4, "#d5963c"}},
                        .strips = {{"BEM", {{1, -1, -.5}, {0, -.5, .5}, {1, .5, 1}}}}};
    const json page = page_of(figure);
    const std::string svg = draw_all({figure}).front().svg;
    EXPECT_EQ(page["kinds"][0]["colour"], "#465678");
    EXPECT_GE(count(svg, "rgb( 70,  86, 120)"), 1u);
    EXPECT_GE(count(svg, "rgb(213, 150,  60)"), 2u);
}

// One table a file: a row per point with the name of its series.
TEST(DrawnFigures, DataAreOneTable) {
    const Figure figure{.id = "zones",
                        .x = {.label = "x", .low = -1, .high = 1},
                        .y = {"p"},
                        .curves = {{.name = "BEM", .x = {-1, 1}, .y = {0, 1}}},
                        .kinds = {{"stick"}, {"slip"}},
                        .strips = {{"BEM", {{1, -1, -.5}, {0, -.5, 1}}}}};
    EXPECT_EQ(
        figure_csv(figure),
        "series,x,to x,p,kind\nBEM,-1,,0,\nBEM,1,,1,\nBEM,-1,-0.5,,slip\nBEM,-0.5,1,,stick\n");
    EXPECT_EQ(figure_csv({.x = {"x"},
                          .y = {"y"},
                          .curves = {{.name = "here", .x = {1}, .y = {2}}},
                          .map = ContourMap{"p", {0, 1}, {0}, {5, nan}}}),
              "series,x,y,p\nmap,0,0,5\nmap,1,0,\nhere,1,2,\n");
    EXPECT_EQ(figure_csv(study()).find("\n\n"), std::string::npos);
    EXPECT_NE(figure_csv(study()).find("\"MDR, f_T = 0.3: shift [µm]\""), std::string::npos);
}

// Words beside an axis stand in both drawings, in the places of 0, 1, ...
TEST(DrawnFigures, NamesStandInThePlaceOfNumbers) {
    const Figure figure{
        .id = "rows",
        .x = {"difference [%]"},
        .y = {.low = 1.5, .high = -.5, .names = {"penalty's", "left_over"}},
        .curves = {{.name = "a", .x = {1, 2}, .y = {0, 1}, .kind = Curve::Kind::points}}};
    EXPECT_EQ(page_of(figure)["y"]["names"].size(), 2u);
    EXPECT_TRUE(page_of(figure)["x"]["names"].empty());
    const std::string svg = draw_all({figure}).front().svg;
    EXPECT_EQ(count(svg, "penalty"), 1u) << svg;
    EXPECT_NE(content_of(figure).find("penalty's"), std::string::npos);
}

}  // namespace
}  // namespace tricontact::report::drawn_figures_test

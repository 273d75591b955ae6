#include "report/gnuplot_figure.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <cmath>
#include <sstream>
#include <system_error>
#include <thread>

#include "report/plot_style.h"

namespace tricontact::report::gnuplot_figure_test {
namespace {

Figure curves() {
    return {.id = "curves",
            .title = "Curves",
            .x = {.label = "position x/a", .low = -1, .high = 1},
            .y = {"u_stat [1]", true},
            .curves = {{.name = "MDR", .x = {-1, 0, 1}, .y = {1, NAN, 3}, .y_error = {.1, .1, .1}},
                       {.name = "it's {a}", .x = {0}, .y = {2}, .kind = Curve::Kind::points},
                       {.name = "exact", .x = {-1, 1}, .y = {2, 2}, .theory = true}},
            .bands = {{.name = "95 %", .x = {-1, 1}, .low = {1, 1}, .high = {2, 3}}},
            .kinds = {{"stick", 0.8}, {"slip", 0.4}},
            .strips = {{"MDR", {{1, -1, -0.5}, {0, -0.5, 0.5}}}}};
}

Figure map() {
    return {.id = "map",
            .x = {"x/a"},
            .y = {"y/a"},
            .curves = {{.name = "largest", .x = {1}, .y = {1}, .kind = Curve::Kind::points}},
            .map = ContourMap{"τ_x", {0, 1, 2}, {0, 1}, {0, 1, 2, 3, NAN, 5}},
            .equal_scales = true};
}

Figure panels() {
    const Panel panel{
        "n = 0", {0, 1, 2}, {0, 1}, {0, 0, -1, 1, 1, 1}, {{.x = {0, 1}, .y = {0, 1}}}};
    return {.id = "panels",
            .x = {.label = "x/a", .low = -0.5, .high = 2.5},
            .y = {.label = "y/a", .low = -0.5, .high = 1.5},
            .kinds = {{"stick", 0.8}, {"slip", 0.4}},
            .panels = {panel, panel},
            .equal_scales = true};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(GnuplotFigure, AllKindsAreDrawnInBothFormats) {
    const std::vector<Figure> figures{curves(), map(), panels()};
    const auto drawings = draw_all(figures);
    ASSERT_EQ(drawings.size(), figures.size());
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const auto& [svg, png] = drawings[i];
        EXPECT_TRUE(svg.starts_with("<?xml")) << figures[i].id;
        EXPECT_TRUE(contains(svg, "</svg>")) << figures[i].id;
        EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n")) << figures[i].id;
        EXPECT_TRUE(contains(png, "IEND")) << figures[i].id;
    }
    for (const char* text : {">position x/a<", ">stick<", ">exact<", ">95 %<"})
        EXPECT_TRUE(contains(drawings[0].svg, text)) << text;
    EXPECT_TRUE(contains(drawings[1].svg, ">largest<"));
    EXPECT_TRUE(contains(drawings[2].svg, ">n\u00a0=\u00a00<"));
}

// Curves of a difference, as of line contacts, keep theirs.
TEST(GnuplotFigure, MapsOfDifferencesHaveNoPng) {
    Figure difference = map(), line = curves();
    difference.id = line.id = "difference_pressure_fem_bem";
    const auto drawings = draw_all({line, difference, curves()});
    ASSERT_EQ(drawings.size(), 3u);
    EXPECT_TRUE(drawings[1].png.empty());
    EXPECT_TRUE(contains(drawings[1].svg, ">largest<"));
    for (const int other : {0, 2}) {
        EXPECT_TRUE(contains(drawings[other].svg, ">exact<"));
        EXPECT_TRUE(drawings[other].png.starts_with("\x89PNG\r\n\x1a\n"));
    }
}

// A drawing that has left its page still says what it shows and what made it.
TEST(GnuplotFigure, DrawingsSayWhatMadeThem) {
    Figure figure = curves();
    figure.title = "p < q";
    figure.caption = "Two curves.";
    figure.provenance = "tricontact 0.1.0: tricontact run a.toml";
    const std::string svg = draw_all({figure}).front().svg;
    EXPECT_TRUE(contains(svg, "<title>p &lt; q</title>"));
    EXPECT_TRUE(
        contains(svg, "<desc>Two curves. (tricontact 0.1.0: tricontact run a.toml)</desc>"));
    EXPECT_FALSE(contains(svg, "Produced by GNUPLOT"));
}

TEST(GnuplotFigure, LabelsInGnuplotsNotation) {
    EXPECT_EQ(gnuplot_label("u_stat [1]"), "u_{stat} [1]");
    EXPECT_EQ(gnuplot_label("C(q) [m^4]"), "C(q) [m^{4}]");
    EXPECT_EQ(gnuplot_label("it's a_b_c {x}"), "it's a\\_b\\_c \\{x\\}");
    EXPECT_EQ(gnuplot_label("a & b < c"), "a \\& b < c");
}

TEST(GnuplotFigure, NamesAreNoCommands) {
    for (const char* name : {"'a.csv", "a.csv'", "it's", "'", "''", "' system 'touch stolen",
                             "`id`", "\"`id`\"", "a\nb\rc", "\\'", "@a\\", "%n $1"}) {
        Figure figure = curves();
        figure.x.label = figure.curves[0].name = figure.curves[1].name = name;
        EXPECT_NO_THROW(draw_all({figure})) << name;
    }
    Figure figure = curves();
    figure.curves[0].name = "'a.csv";
    EXPECT_TRUE(contains(picture_of(figure).script, "title ''.\"'\".'a.csv'"));
}

TEST(GnuplotFigure, TheScriptHoldsTheData) {
    const std::string script = picture_of(curves()).script;
    EXPECT_TRUE(contains(script, "-1 1 \n\n1 3 \nEOD"));  // a gap is an empty line
    EXPECT_TRUE(contains(script, "set logscale y"));
    EXPECT_TRUE(contains(script, "set xrange [-1:1]"));
    EXPECT_TRUE(contains(script, "title 'exact'"));
    // Two cells of stick in the first row are one box.
    EXPECT_TRUE(contains(picture_of(panels()).script, "0.5 0.075 -0.5 1.5 -0.5 0.65 \nEOD"));
    EXPECT_TRUE(contains(picture_of(map()).script, "1 1 NaN\n"));
}

// One entry of the key for a line and the places that are marked on it.
TEST(GnuplotFigure, TheKeyShowsTheMarkersOfALine) {
    Figure figure = curves();
    EXPECT_FALSE(contains(picture_of(figure).script, "keyentry"));
    figure.curves.push_back({.name = "MDR", .x = {0}, .y = {2}, .kind = Curve::Kind::points});
    const std::string script = picture_of(figure).script;
    EXPECT_TRUE(contains(script, "keyentry with linespoints"));
    const std::string entry = "title 'MDR'";
    EXPECT_EQ(script.find(entry), script.rfind(entry));
}

TEST(GnuplotFigure, AMapEndsWhereItsValuesDo) {
    const std::string script = picture_of(map()).script;
    EXPECT_TRUE(contains(script, "set xrange [0:2]"));
    EXPECT_TRUE(contains(script, "set yrange [0:1]"));
    EXPECT_TRUE(contains(script, "set ylabel 'y/a'"));
}

// Pixels at quarters of cells, linear between corners: of 0, 1 above 3 and no value nothing is
// known.
TEST(GnuplotFigure, MapsAreImages) {
    Figure figure = map();
    EXPECT_TRUE(contains(picture_of(figure).script, "NaN NaN NaN NaN\nNaN NaN NaN NaN\nEOD"));
    figure.map->values[4] = 4;  // x + 3 y
    EXPECT_TRUE(contains(picture_of(figure).script, "1 1.5 2 2.5\n2.5 3 3.5 4\nEOD"));
    EXPECT_TRUE(contains(picture_of(figure).script, "set x2range [-0.5:3.5]"));
    figure.x.low = 1;  // the image ends where the axis does, not with a pixel
    figure.y.low = .5;
    EXPECT_TRUE(contains(picture_of(figure).script, "$pixels << EOD\n3.5 4\nEOD"));
    figure.x.logarithmic = true;
    EXPECT_TRUE(contains(picture_of(figure).script, "with pm3d"));
    EXPECT_NO_THROW(draw_all({figure}));
}

// y^2 = 2: two lines along x with as many points.
TEST(GnuplotFigure, LinesOfEqualValueAreNotJoined) {
    Figure figure = map();
    figure.map = ContourMap{
        "y^2", {0, 1, 2}, {-2, -1, 0, 1, 2}, {4, 4, 4, 1, 1, 1, 0, 0, 0, 1, 1, 1, 4, 4, 4}, {2}};
    const std::string svg = draw_all({figure}).front().svg;
    const std::string line = "stroke='rgb( 26,  26,  26)'  d='";
    int n_lines = 0;
    for (auto at = svg.find(line); at != std::string::npos; at = svg.find(line, at)) {
        at += line.size();
        std::istringstream path(svg.substr(at, svg.find('\'', at) - at));
        std::string point, height;
        while (path >> point) {  // "M74.96,341.73", then "L290.57,341.73"
            const std::string here = point.substr(point.find(',') + 1);
            if (point.front() == 'M') ++n_lines, height = here;
            EXPECT_EQ(here, height);
        }
    }
    EXPECT_EQ(n_lines, 2);
}

// Where the system gives no further thread - here none whose stack is larger than all addresses -
// one draws them all.
TEST(GnuplotFigure, OneThreadDrawsWhatMoreWouldDraw) {
    const std::vector<Figure> figures{curves(), panels()};
    const auto due = draw_all(figures);
    pthread_attr_t usual, none;
    ASSERT_EQ(pthread_getattr_default_np(&usual), 0);
    ASSERT_EQ(pthread_attr_init(&none), 0);
    ASSERT_EQ(pthread_attr_setstacksize(&none, std::size_t{1} << 60), 0);
    ASSERT_EQ(pthread_setattr_default_np(&none), 0);
    EXPECT_THROW(std::thread([] {}).join(), std::system_error);
    const auto drawings = draw_all(figures);
    ASSERT_EQ(pthread_setattr_default_np(&usual), 0);
    ASSERT_EQ(drawings.size(), due.size());
    for (std::size_t i = 0; i < due.size(); ++i) {
        EXPECT_EQ(drawings[i].svg, due[i].svg) << figures[i].id;
        EXPECT_EQ(drawings[i].png, due[i].png) << figures[i].id;
    }
}

// Found: no machine of a sweep walked, and "x range is invalid" ended the command.
TEST(GnuplotFigure, FiguresWithoutAPointAreDrawn) {
    Figure figure = curves();
    figure.x = {.label = "x"};
    figure.bands.clear();
    figure.strips.clear();
    figure.curves = {{.name = "none", .x = {NAN, 2}, .y = {1, NAN}, .kind = Curve::Kind::points}};
    EXPECT_TRUE(contains(draw_all({figure}).front().svg, "</svg>"));
    figure.x.logarithmic = true;
    EXPECT_TRUE(contains(draw_all({figure}).front().svg, "</svg>"));
    figure.x = {.label = "x", .low = 0, .high = 2};
    figure.y = {"y"};
    figure.curves.front() = {.name = "none", .x = {0, 2}, .y = {NAN, NAN}};
    figure.bands = {{.name = "of none", .x = {0, 2}, .low = {NAN, NAN}, .high = {NAN, NAN}}};
    EXPECT_TRUE(contains(draw_all({figure}).front().svg, "</svg>"));
    Figure empty = map();
    empty.curves = figure.curves;
    empty.map->values.assign(6, NAN);
    EXPECT_TRUE(contains(draw_all({empty}).front().svg, "</svg>"));
}

TEST(GnuplotFigure, ErrorsOfGnuplotReachTheCaller) {
    Figure broken = curves();
    broken.x.low = NAN;
    EXPECT_THROW(draw_all({broken}), GnuplotError);
}

}  // namespace
}  // namespace tricontact::report::gnuplot_figure_test

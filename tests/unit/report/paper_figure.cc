#include "report/paper_figure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/gnuplot_figure.h"

namespace tricontact::report::paper_figure_test {
namespace {

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Figure curves() {
    Figure figure{.id = "curves",
                  .caption = "Two curves.",
                  .x = {"x [mm]"},
                  .y = {"u [1]"},
                  .curves = {{.name = "MDR"}, {.name = "BEM"}, {.name = "exact", .theory = true}}};
    for (Curve& curve : figure.curves) curve.sample(0, 1, 70, [](double x) { return x * x; });
    return figure;
}

Figure panels() {
    const Panel panel{"n = 0", {0, 1, 2}, {0, 1}, {0, 0, -1, 1, 1, 1}};
    return {.id = "panels",
            .x = {.label = "x/a", .low = -0.5, .high = 2.5},
            .y = {.label = "y/a", .low = -0.5, .high = 1.5},
            .kinds = {{"stick", 0.8}, {"slip", 0.4}},
            .panels = {panel, panel, panel, panel}};
}

TEST(PaperFigure, EachFormatIsOneColumnWide) {
    const auto drawings = draw_for_papers({curves(), panels()});
    ASSERT_EQ(drawings.size(), 2U);
    EXPECT_TRUE(drawings[0].pdf.starts_with("%PDF-"));
    EXPECT_TRUE(contains(drawings[0].svg, "width=\"86.00mm\""));
    EXPECT_TRUE(contains(drawings[0].svg, "<desc>Two curves.</desc>"));
    EXPECT_TRUE(drawings[0].png.starts_with("\x89PNG\r\n\x1a\n"));
    // 600 dots an inch: width in the header of PNG, big-endian, at byte 16.
    const auto byte = [&](int i) { return static_cast<unsigned char>(drawings[0].png[i]); };
    EXPECT_EQ((byte(18) << 8) + byte(19), std::lround(86 / 25.4 * 600));
    // 86 mm are 243.8 points, the unit of PDF.
    EXPECT_TRUE(contains(drawings[0].pdf, "/MediaBox [ 0 0 24"));
    // Maps side by side have two columns.
    EXPECT_TRUE(contains(drawings[1].svg, "width=\"178.00mm\""));
}

TEST(PaperFigure, TheSameFigureHasTheSameBytes) {
    const auto first = draw_for_papers({curves()}), again = draw_for_papers({curves()});
    EXPECT_EQ(first[0].pdf, again[0].pdf);
    EXPECT_EQ(first[0].svg, again[0].svg);
    EXPECT_EQ(first[0].png, again[0].png);
    EXPECT_TRUE(contains(first[0].pdf, "/CreationDate (D:20000101000000"));
}

// Models' lines have markers of their own, closed forms dashes.
TEST(PaperFigure, CurvesDifferInGrey) {
    const std::string page = picture_of(curves()).script;
    EXPECT_FALSE(contains(page, "pointinterval"));
    const std::string paper = picture_of(curves(), {.in_grey = true}).script;
    EXPECT_TRUE(contains(paper, "pointtype 7 pointsize 0.7 pointinterval 10"));
    EXPECT_TRUE(contains(paper, "pointtype 5 pointsize 0.7 pointinterval 10"));
    EXPECT_TRUE(contains(paper, "dashtype 2 title 'exact'"));
}

}  // namespace
}  // namespace tricontact::report::paper_figure_test

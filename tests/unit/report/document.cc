#include "report/document.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "report/base64.h"
#include "report/chart_json.h"
#include "report/csv.h"
#include "report/document_csv.h"
#include "report/page_templates.h"

namespace tricontact::report::document_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Figure curves() {
    return {.id = "shift",
            .title = "Shift",
            .caption = "Shift over f_T, w = 0.1.",
            .x = {"f_T [1]"},
            .y = {"u [1]"},
            .curves = {{.name = "MDR", .x = {0.1, 0.2}, .y = {0.5, nan}, .y_error = {0.01, 0.02}},
                       {.name = "BEM, fine", .x = {0.1, 0.2}, .y = {0.4, 0.6}},
                       {.name = "limit", .x = {0.3}, .y = {1}, .theory = true}},
            .bands = {{.name = "95 %", .x = {0.3}, .low = {0.9}, .high = {1.1}}}};
}

Figure contour_map() {
    return {.id = "deviation",
            .title = "Deviation",
            .caption = "Of the radius.",
            .x = {"b [mm]", true},
            .y = {"ν [1]"},
            .map = ContourMap{"Δa [%]", {1, 2}, {0.3, 0.4, 0.5}, {1, 2, 3, nan, 5, 6}}};
}

DocumentTable table() {
    return {.id = "points",
            .title = "Points",
            .note = "u at the end.",
            .columns = {{"model"}, {"u [1]", 3}, {"κ [1]"}},
            .rows = {{std::string("bem"), 0.123456, WithError{1.06, 0.119}},
                     {std::string("a \"b\", c"), nan, WithError{nan, nan}}}};
}

Document document() {
    return {.kind = "Study",
            .title = "Layer & <b>half-space</b>",
            .lead = "How far does f_T go?",
            .verdicts = {{Verdict::Standing::holds, "The limit holds."},
                         {Verdict::Standing::violated, "κ is no constant."},
                         {Verdict::Standing::not_testable, "Too few points."},
                         {Verdict::Standing::finding, "E = 5.2 MPa."}},
            .settings = {{"layer", "8 mm"}},
            .sections = {{"first", "First", {"Words <i>."}, {curves(), contour_map()}, {table()}}},
            .files = {{"all points", "points.csv"}},
            .command = "tricontact sweep \"a b.toml\"",
            .version = "1.2.3"};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

std::string without_library(std::string page) {
    const std::size_t at = page.find(chart_library());
    return at == std::string::npos ? page : page.erase(at, chart_library().size());
}

TEST(Csv, Rfc4180) {
    EXPECT_EQ(csv_field(std::string("a")), "a");
    EXPECT_EQ(csv_field(std::string("a,\"b\"\n")), "\"a,\"\"b\"\"\n\"");
    EXPECT_EQ(csv_field(0.1), "0.1");
    EXPECT_EQ(csv_field(nan), "");
    EXPECT_EQ(csv_line({"", "b", ""}), ",b,\n");
}

TEST(DocumentCsv, CurvesSideBySide) {
    EXPECT_EQ(figure_csv(curves()),
              "f_T [1],MDR: u [1],± MDR: u [1],\"BEM, fine: u [1]\",f_T [1],limit: u [1],"
              "\"95 %, low: u [1]\",\"95 %, high: u [1]\"\n"
              "0.1,0.5,0.01,0.4,0.3,1,0.9,1.1\n"
              "0.2,,0.02,0.6,,,,\n");
}

TEST(DocumentCsv, MapsARowPerNode) {
    EXPECT_EQ(figure_csv(contour_map()),
              "b [mm],ν [1],Δa [%]\n1,0.3,1\n2,0.3,2\n1,0.4,3\n2,0.4,\n1,0.5,5\n2,0.5,6\n");
}

TEST(DocumentCsv, TablesWithAllDigits) {
    EXPECT_EQ(table_csv(table()),
              "model,u [1],κ [1],± κ [1]\nbem,0.123456,1.06,0.119\n\"a \"\"b\"\", c\",,,\n");
}

TEST(ChartJson, GapsAreNull) {
    const auto of_curves = figure_json(curves()), of_map = figure_json(contour_map());
    EXPECT_EQ(of_curves["curves"][0]["y"].dump(), "[0.5,null]");
    EXPECT_EQ(of_map["map"]["rows"].dump(), "[[1.0,2.0],[3.0,null],[5.0,6.0]]");
    EXPECT_TRUE(of_curves["map"].is_null());
    EXPECT_TRUE(of_map["x"]["logarithmic"]);
    Figure quoted = curves();
    quoted.x.label = "Poisson's \"ν\" < 1";
    EXPECT_EQ(figure_json(quoted)["x"]["label"], "Poisson's \"ν\" &lt; 1");
    EXPECT_EQ(of_curves["x"]["label"], "<i>f</i><sub>T</sub> [1]");
}

// What a reader hears who cannot see the drawing.
TEST(Figure, ContentNamesAxesAndRanges) {
    EXPECT_EQ(content_of(curves()),
              "u [1] over f_T [1]. MDR: 0.500. BEM, fine: 0.400 to 0.600. limit: 1.00. "
              "95 %: 0.900 to 1.10.");
    EXPECT_EQ(content_of(contour_map()), "ν [1] over b [mm]. Δa [%]: 1.00 to 6.00.");
}

// A model has its colour whatever else is drawn and in which order.
TEST(ChartJson, ModelsHaveOneColourEverywhere) {
    Figure figure = curves();
    figure.curves = {{.name = "half-space"},
                     {.name = "FEM"},
                     {.name = "bem-layer"},
                     {.name = "MDR layer"},
                     {.name = "BEM layer"}};
    std::string styles;
    const auto json = figure_json(figure);
    for (const auto& curve : json["curves"]) styles += curve["style"].dump() + " ";
    EXPECT_EQ(styles, "0 3 2 4 2 ");  // what is no model takes the first that no model has
}

TEST(ChartJson, StylesFollowNamesAndColours) {
    Figure figure = curves();
    figure.curves = {{.name = "coarse", .x = {}, .y = {}},
                     {.name = "MDR", .x = {}, .y = {}, .colour = 0},
                     {.name = "limit", .x = {}, .y = {}, .theory = true},
                     {.name = "fine", .x = {}, .y = {}},
                     {.name = "coarse", .x = {}, .y = {}},
                     {.name = "exact", .x = {}, .y = {}, .theory = true, .colour = 1}};
    std::string styles;
    const auto json = figure_json(figure);
    for (const auto& curve : json["curves"]) styles += curve["style"].dump() + " ";
    EXPECT_EQ(styles, "2 0 null 3 2 1 ");  // 0 and 1 are taken
    figure.bands = {{.name = "fine", .x = {}, .low = {}, .high = {}},
                    {.name = "95 %", .x = {}, .low = {}, .high = {}},
                    {.name = "fine", .x = {}, .low = {}, .high = {}, .colour = 4}};
    const auto with_bands = figure_json(figure);
    EXPECT_EQ(with_bands["bands"][0]["style"], 3);
    EXPECT_TRUE(with_bands["bands"][1]["style"].is_null());
    EXPECT_EQ(with_bands["bands"][2]["style"], 4);
}

TEST(ChartLibrary, CanStandInAPageAndNamesItsLicence) {
    const std::string library(chart_library());
    EXPECT_TRUE(library.starts_with("/*!\nMIT License\n"));
    EXPECT_TRUE(contains(library, "Permission is hereby granted, free of charge"));
    EXPECT_TRUE(contains(library, "window.Plotly = Plotly;"));
    EXPECT_FALSE(contains(library, "</script"));
    EXPECT_FALSE(contains(library, "<!--"));
}

TEST(DocumentHtml, VerdictsComeFirstAndInWords) {
    const std::string page = document_html(document());
    EXPECT_TRUE(contains(page, "<li class=\"holds\"><b>holds</b> <span>The limit holds."));
    EXPECT_TRUE(contains(page, "<li class=\"violated\"><b>violated</b>"));
    EXPECT_TRUE(contains(page, "<li class=\"not_testable\"><b>not testable</b>"));
    EXPECT_TRUE(contains(page, "<li class=\"finding\"><b>finding</b>"));
    EXPECT_LT(page.find("class=\"verdicts\""), page.find("<figure"));
}

TEST(DocumentHtml, TextsAreEscapedAndTypeset) {
    const std::string page = document_html(document());
    EXPECT_TRUE(contains(page, "<title>Layer &amp; &lt;b&gt;half-space&lt;/b&gt; – Tricontact"));
    EXPECT_TRUE(contains(page, "How far does <i>f</i><sub>T</sub> go?"));
    EXPECT_TRUE(contains(page, "Words &lt;i&gt;."));
    EXPECT_TRUE(contains(page, "tricontact sweep &quot;a b.toml&quot;"));
    EXPECT_FALSE(contains(without_library(page), "{{"));
}

TEST(DocumentHtml, CellsAsReadAndAsSorted) {
    const std::string page = document_html(document());
    EXPECT_TRUE(
        contains(page,
                 "<th scope=\"row\" data-words>bem</th><td data-value=\"0.123456\">0.123</td>"
                 "<td data-value=\"1.06\">1.06 ± 0.12</td>"));
    EXPECT_TRUE(contains(page, "<td>–</td><td>–</td>"));
}

TEST(DocumentHtml, ColumnsOfWholeNumbersHaveNoDecimals) {
    Document whole = document();
    whole.sections[0].tables = {
        {.id = "t", .title = "T", .columns = {{"n"}, {"x"}}, .rows = {{3., 3.}, {nan, 0.5}}}};
    EXPECT_TRUE(contains(document_html(whole),
                         "<td data-value=\"3\">3</td>"
                         "<td data-value=\"3\">3.000</td>"));
}

TEST(DocumentHtml, CellsLeadToFiles) {
    Document page = document();
    page.sections.back().tables = {{.id = "t",
                                    .title = "T",
                                    .columns = {{"n"}, {"file"}},
                                    .rows = {{3., Link{"a < b", "p/\"q\".pvd"}}}}};
    EXPECT_TRUE(contains(document_html(page), R"(<a href="p/&quot;q&quot;.pvd">a &lt; b</a>)"));
    EXPECT_EQ(table_csv(page.sections.back().tables[0]), "n,file\n3,\"p/\"\"q\"\".pvd\"\n");
}

TEST(DocumentHtml, DataAreLinksThatNeedNoScript) {
    const std::string page = document_html(document());
    for (const Figure& figure : {curves(), contour_map()})
        EXPECT_TRUE(contains(page, "<a download=\"" + figure.id +
                                       ".csv\" href=\"data:text/csv;charset=utf-8;base64," +
                                       base64(figure_csv(figure)) + "\""));
    EXPECT_TRUE(contains(page, "<a download=\"points.csv\""));
    EXPECT_TRUE(contains(page, "<a href=\"points.csv\">all points</a>"));
}

TEST(DocumentHtml, NeedsNoNetworkAndNoOtherFile) {
    const std::string page = without_library(document_html(document()));
    for (const char* part :
         {"http:", "https:", " src=", "<link rel=\"stylesheet", "@import", "url("})
        EXPECT_FALSE(contains(page, part)) << part;
}

TEST(DocumentHtml, TextsCannotEndTheScript) {
    Document hostile = document();
    hostile.sections[0].figures[0].title = "</script><script>alert(1)</script>";
    hostile.sections[0].figures[0].curves[0].name = "</script>\n<!-- \xff";
    const std::string page = without_library(document_html(hostile));
    EXPECT_EQ(count(page, "<script"), 4u);  // data of two figures, library, drawing
    EXPECT_EQ(count(page, "</script"), 4u);
    EXPECT_FALSE(contains(page, "<!--"));
}

// CSS Syntax 3, 4.3.7: a backslash, the number of the character in base 16, one blank that ends it.
TEST(DocumentHtml, TitlesCannotEndTheStyle) {
    Document hostile = document();
    hostile.title = "a \"b\" \\ </style>\nκ";
    const std::string page = without_library(document_html(hostile));
    EXPECT_TRUE(contains(page, "content: \"a \\22 b\\22  \\5c  \\3c /style>\\a κ\""));
    EXPECT_EQ(count(page, "</style"), 1u);
}

TEST(DocumentHtml, ElementsAreClosed) {
    const std::string page = without_library(document_html(document()));
    for (const std::string element :
         {"section", "table", "tbody", "thead", "tr", "th",     "td",         "ul",   "li",  "p",
          "div",     "dl",    "dt",    "dd",    "a",  "figure", "figcaption", "span", "pre", "b"})
        EXPECT_EQ(count(page, "<" + element + ">") + count(page, "<" + element + " "),
                  count(page, "</" + element + ">"))
            << element;
}

TEST(DocumentHtml, EmptyPartsLeaveNothingBehind) {
    const std::string page = document_html({.kind = "Study", .title = "Nothing"});
    for (const char* part :
         {"<figure", "<table", "id=\"setting\"", "id=\"origin\"", "<nav></nav>", "id=\"verdicts\""})
        EXPECT_FALSE(contains(page, part)) << part;
    Document hollow = document();
    Figure figure{.id = "f", .title = "F", .caption = "", .x = {"x"}, .y = {"y"}};
    DocumentTable points{.id = "t", .title = "T", .columns = {}, .rows = {}};
    hollow.sections = {{"first", "First", {}, {figure}, {points}}};
    EXPECT_TRUE(contains(document_html(hollow), "<figure id=\"figure_f\""));
}

TEST(DocumentHtml, SameDocumentSameBytes) {
    EXPECT_EQ(document_html(document()), document_html(document()));
}

/// What document_html says about a document with one change.
template <class Change>
std::string refusal(const Change& change) {
    Document changed = document();
    change(changed.sections.front());
    try {
        document_html(changed);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(DocumentHtml, RefusesWhatHasNoPlaceOrNoPartner) {
    EXPECT_EQ(refusal([](auto& s) { s.figures[0].id = "a b"; }),
              "document: figure 'a b': an id consists of letters, digits, hyphens and underscores");
    EXPECT_EQ(refusal([](auto& s) { s.tables[0].id = ""; }),
              "document: table '': an id consists of letters, digits, hyphens and underscores");
    EXPECT_EQ(refusal([](auto& s) { s.figures[1].id = "shift"; }),
              "document: figure 'shift': the id occurs twice");
    EXPECT_EQ(refusal([](auto& s) { s.id = "setting"; }),
              "document: section 'setting': the id occurs twice");
    EXPECT_EQ(refusal([](auto& s) { s.figures[0].curves[1].y.pop_back(); }),
              "document: figure 'shift': 1 values where x has 2");
    EXPECT_EQ(refusal([](auto& s) { s.figures[1].map->values.pop_back(); }),
              "document: figure 'deviation': 5 values on a grid of 2 by 3");
    EXPECT_EQ(refusal([](auto& s) {
                  s.figures[1].map->x = {2, 1};
              }),
              "document: figure 'deviation': the grid of a map increases along both axes");
    EXPECT_EQ(refusal([](auto& s) { s.tables[0].rows[0].pop_back(); }),
              "document: table 'points': a row of 2 cells under 3 headings");
}

}  // namespace
}  // namespace tricontact::report::document_test

// What a comparison is told as: JSON, CSV, junit.xml, terminal, page.

#include "benchmarks/report/comparison_output.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "benchmarks/report/comparison_figures.h"
#include "tests/unit/benchmarks/report/hertz_comparison.h"

namespace tricontact::benchmarks::comparison_output_test {
namespace {

std::ptrdiff_t count(const std::string& text, const std::string& part) {
    std::ptrdiff_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

bool contains(const std::string& text, const std::string& part) {
    return count(text, part) > 0;
}

// Keys that the issue promises to scripts.
TEST(ComparisonOutput, JsonHasThePromisedKeys) {
    const auto json = comparison_json("1", hertz_comparison());
    const auto& force = json.at("quantities").at("normal_force");
    EXPECT_EQ(force.at("verdict"), "pass");
    EXPECT_EQ(force.at("verdict_unexplained"), "fail");
    EXPECT_NEAR(force.at("difference"), .0145, 1e-12);
    EXPECT_NEAR(force.at("explained"), .0178, 1e-12);
    EXPECT_NEAR(force.at("left"), -.0033, 1e-12);
    EXPECT_EQ(force.at("uncertainty"), .0041);
    EXPECT_EQ(json.at("quantities").at("pressure_l2").at("verdict"), "not-resolved");
    EXPECT_EQ(json.at("quantities").at("peak_pressure").at("values").at(0), nullptr);
    EXPECT_EQ(json.at("diagnoses").at(0).at("id"), "penalty");
    EXPECT_EQ(json.at("meshes").size(), 3u);
    EXPECT_EQ(json.at("verdict"), "fail");
    EXPECT_EQ(json.at("case").at("substrate").at("poisson"), .3);
}

TEST(ComparisonOutput, CsvHasARowForEachNumberAndMesh) {
    EXPECT_EQ(count(comparison_csv(hertz_comparison()), "\n"), 1 + 3 * 3);
}

TEST(ComparisonOutput, JunitCountsWhatFailsAndWhatIsNotResolved) {
    Comparison comparison = hertz_comparison();
    const std::string text = junit_xml(comparison);
    EXPECT_TRUE(contains(text, "tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\"")) << text;
    EXPECT_EQ(count(text, "<testcase "), 3);
    EXPECT_EQ(count(text, "<failure "), 1);
    EXPECT_TRUE(contains(text, "two more meshes"));
    comparison.submission.code = "a \"<&>\" b\x01";
    EXPECT_TRUE(contains(junit_xml(comparison), "a &quot;&lt;&amp;&gt;&quot; b?"));
}

TEST(ComparisonOutput, TerminalHasBothVerdictsAndTheBudget) {
    Comparison comparison = hertz_comparison();
    comparison.standing = Standing::pass;
    const std::string text = comparison_text(comparison);
    EXPECT_TRUE(text.starts_with("pass: CalculiX 2.20 on ")) << text;
    EXPECT_TRUE(contains(text, "without what is explained: fail")) << text;
    EXPECT_TRUE(contains(text, "−0.33 ± 0.41 %")) << text;
    EXPECT_TRUE(contains(text, "K = 1100 MPa/mm")) << text;
    EXPECT_TRUE(contains(text, "L2 norm of p: not resolved for discretisation; two more meshes"));
    EXPECT_EQ(count(text, "column CPRESS"), 1) << text;
    comparison.unexplained_standing = Standing::pass;
    EXPECT_FALSE(contains(comparison_text(comparison), "without what is explained"));
}

// The waterfall ends where the number's own sum does.
TEST(ComparisonOutput, BudgetEndsAtWhatIsLeft) {
    const ComparedNumber number = hertz_comparison().numbers.front();
    const report::Figure figure = budget_figure(number);
    ASSERT_EQ(figure.y.names.size(), 4u);
    const auto left = std::ranges::find_if(figure.curves, [](const report::Curve& curve) {
        return curve.name == "left" && !curve.x_error.empty();
    });
    ASSERT_NE(left, figure.curves.end());
    EXPECT_NEAR(left->x.front(), 100 * number.left(), 1e-12);
    EXPECT_EQ(left->x_error.front(), 100 * number.uncertainty);
}

// Rings of even width, values of their middles: the load inside r is Hertz' to h^2.
TEST(ComparisonOutput, LoadInsideIsThatOfTheClosedForm) {
    Comparison comparison = hertz_comparison();
    comparison.meshes = {hertz_mesh(HertzFields(), Geometry::axisymmetric, 5e-5, 1)};
    const auto figures = load_figures(comparison);
    ASSERT_EQ(figures.size(), 2u);
    for (const double percent : figures[1].curves.front().y) EXPECT_NEAR(percent, 0, .05);
}

TEST(ComparisonOutput, PageIsMadeForAxesPlanesAndSpace) {
    for (const Geometry geometry : {Geometry::axisymmetric, Geometry::spatial}) {
        const Comparison comparison = hertz_comparison(geometry);
        report::Document document = comparison_document(comparison);
        document.version = "1";
        const std::string page = document_html(document);
        EXPECT_TRUE(contains(page, "budget_normal_force"));
        EXPECT_TRUE(contains(page, "V&amp;V 20, ASME (2009)"));
        EXPECT_EQ(contains(page, "chart_difference_pressure"), geometry == Geometry::spatial);
    }
    // Without fields, meshes of a size or anything explained, what rests on them is left out.
    Comparison bare = hertz_comparison();
    bare.reference.fields.reset();
    bare.numbers = {bare.numbers.back()};
    for (MeshResult& mesh : bare.meshes) mesh.size = 0;
    const report::Document document = comparison_document(bare);
    EXPECT_NO_THROW(check_document(document));
    EXPECT_EQ(report::figures_of(document).size(), 1u);
}

TEST(ComparisonOutput, FilesHaveTheNamesThatAreSaid) {
    const auto names = comparison_file_names();
    for (const OutputFile& file : comparison_files(hertz_comparison(), {"1", "tricontact"}))
        EXPECT_TRUE(std::ranges::count(names, file.name)) << file.name;
}

}  // namespace
}  // namespace tricontact::benchmarks::comparison_output_test

#include "benchmarks/problems/problem_page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tricontact::problem_page_test {
namespace {

using benchmarks::Problem;

std::vector<const Problem*> all() {
    std::vector<const Problem*> problems;
    for (const Problem& one : benchmarks::catalogue()) problems.push_back(&one);
    return problems;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A reference whose numbers are given.
benchmarks::Reference reference() {
    benchmarks::Reference given;
    given.values["normal_force"] = {.value = 16.48899, .grid = .0007, .source = "mdr-layer"};
    given.values["indentation"] = {.value = .35e-3};
    given.prescribed = {"indentation"};
    given.models = {"mdr-layer"};
    given.remarks = {"It leaves out nothing."};
    return given;
}

TEST(ProblemPage, ListNamesAllProblems) {
    const std::string text = benchmarks::catalogue_text(all());
    const auto json = nlohmann::json::parse(benchmarks::catalogue_json(all()));
    EXPECT_EQ(json.size(), all().size());
    for (const Problem* one : all()) {
        EXPECT_TRUE(has(text, one->name)) << one->name;
        EXPECT_TRUE(has(benchmarks::catalogue_markdown(all()), '[' + one->name + ']')) << one->name;
    }
}

TEST(ProblemPage, LinesFitTheTerminal) {
    for (const Problem* one : all()) {
        std::size_t begin = 0, longest = 0;
        const std::string text = benchmarks::problem_text(*one, {});
        for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos;
             begin = end + 1)
            longest = std::max(longest, end - begin);
        EXPECT_LE(longest, 120u) << one->name;
    }
}

TEST(ProblemPage, ShowsReferenceInTheUnitsOfItsTargets) {
    const Problem& problem = benchmarks::required_problem("layer_pressed");
    const auto given = reference();
    for (const std::string& page : {benchmarks::problem_text(problem, {&given}),
                                    benchmarks::problem_markdown(problem, {&given})}) {
        EXPECT_TRUE(has(page, "16.4890 ± 0.0007 N"));
        EXPECT_TRUE(has(page, "mdr-layer"));
        EXPECT_TRUE(has(page, "It leaves out nothing."));
        EXPECT_FALSE(has(page, "indentation d"));  // the case prescribes it
    }
    const auto json = nlohmann::json::parse(benchmarks::problem_json(problem, {&given, ""}));
    EXPECT_NEAR(json["reference"]["quantities"]["normal_force"]["bar"].get<double>(), .0007, 1e-9);
    EXPECT_TRUE(json["reference"]["quantities"]["indentation"]["prescribed"].get<bool>());
    EXPECT_TRUE(
        nlohmann::json::parse(benchmarks::problem_json(problem, {}))["reference"].is_null());
}

TEST(ProblemPage, SaysWhyThereIsNoReference) {
    const Problem& problem = benchmarks::required_problem("patch_test");
    EXPECT_TRUE(has(benchmarks::problem_text(problem, {.no_reference = "It has closed forms."}),
                    "It has closed forms."));
    EXPECT_FALSE(has(benchmarks::problem_text(problem, {}), "Reference"));
}

TEST(ProblemPage, ShowsNumbersOfOtherProblemsApart) {
    const std::string page =
        benchmarks::problem_markdown(benchmarks::required_problem("two_spheres"), {});
    const auto other = page.find("## Published, of other problems");
    ASSERT_NE(other, std::string::npos);
    EXPECT_GT(page.find("3176.3 MPa", other), other);
    EXPECT_TRUE(has(page, "13.5 % above Hertz"));
    EXPECT_FALSE(has(benchmarks::problem_markdown(benchmarks::required_problem("carter"), {}),
                     "of other problems"));
}

}  // namespace
}  // namespace tricontact::problem_page_test

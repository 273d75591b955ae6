#include <gtest/gtest.h>

#include "benchmarks/problems/problem.h"
#include "benchmarks/reference/quantity_units.h"
#include "contact/base/error.h"

namespace tricontact::problem_reader_test {
namespace {

const std::string head = R"(
title = "t"
group = "layer"
tests = "penalty"
text = "x"
traps = ["one"]
sources = ["Hertz, 1882"]
)";

std::string message_of(const std::string& text) {
    try {
        benchmarks::parse_problem(text, "p");
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(ProblemReader, TurnsUnitsIntoSI) {
    const auto problem = benchmarks::parse_problem(
        head +
            "[target.peak_pressure]\nvalue = 2.5\nunit = \"MPa\"\nbar = 0.5\nsource = \"s\"\n"
            "[target.other]\nquantity = \"contact_radius\"\nvalue = 3\nunit = \"mm\"\n"
            "source = \"s\"\nsolution = false\nremark = \"of a block\"\n",
        "p");
    ASSERT_EQ(problem.targets.size(), 2u);
    EXPECT_DOUBLE_EQ(problem.targets[0].value, 2.5e6);
    EXPECT_DOUBLE_EQ(problem.targets[0].bar, .5e6);
    EXPECT_EQ(problem.targets[0].title, "peak pressure p0");
    EXPECT_EQ(problem.targets[1].key, "contact_radius");
    EXPECT_DOUBLE_EQ(problem.targets[1].value, 3e-3);
    EXPECT_FALSE(problem.targets[1].is_solution);
    EXPECT_TRUE(problem.case_text.empty());
    EXPECT_FALSE(problem.twin);
}

// Both spellings are read; texts for people have the micro sign.
TEST(ProblemReader, ReadsMicrometresEitherWay) {
    for (const std::string unit : {"um", "µm"}) {
        const auto problem = benchmarks::parse_problem(
            head + "[target.indentation]\nvalue = 3\nunit = \"" + unit + "\"\nsource = \"s\"\n",
            "p");
        EXPECT_DOUBLE_EQ(problem.targets.at(0).value, 3e-6);
        ASSERT_TRUE(benchmarks::find_unit(unit));
        EXPECT_EQ(benchmarks::find_unit(unit)->word, "µm");
    }
}

TEST(ProblemReader, RefusesWhatItDoesNotKnow) {
    EXPECT_EQ(message_of(head + "trap = [\"a\"]\n").substr(0, 33),
              "p.toml:8:1: unknown key trap; did");
    EXPECT_NE(message_of(head + "[target.indentation]\nvalu = 1\n").find("unknown key"),
              std::string::npos);
    EXPECT_NE(message_of(head + "[goal.indentation]\nvalue = 1\n").find("unknown section"),
              std::string::npos);
    EXPECT_NE(message_of("title = \"t\"\n").find("missing key group"), std::string::npos);
}

TEST(ProblemReader, RefusesTargetsThatSayTooLittle) {
    const std::string target = head + "[target.contact_radius]\nvalue = 1\n";
    EXPECT_NE(message_of(target + "unit = \"MPa\"\nsource = \"s\"\n").find("unit does not fit"),
              std::string::npos);
    EXPECT_NE(message_of(target + "source = \"s\"\n").find("unit does not fit"), std::string::npos);
    EXPECT_NE(message_of(target + "unit = \"mm\"\n").find("names no source"), std::string::npos);
    EXPECT_NE(message_of(target + "unit = \"mm\"\nsource = \"s\"\nsolution = false\n")
                  .find("has a remark"),
              std::string::npos);
    EXPECT_NE(message_of(head + "[target.ratio]\nvalue = 1\nsource = \"s\"\n").find("has no title"),
              std::string::npos);
    EXPECT_NE(message_of(head + "[target.contact_radius]\nunit = \"mm\"\n").find("missing key"),
              std::string::npos);
}

}  // namespace
}  // namespace tricontact::problem_reader_test

#include <algorithm>
#include <cctype>

#include "app/benchmark/benchmark_case.h"
#include "app/commands/command.h"
#include "benchmarks/problems/problem_page.h"
#include "io/keys/messages.h"

namespace tricontact::app {

namespace {

using benchmarks::Problem;
using benchmarks::ProblemFindings;

struct BenchmarkListOptions : CommandOptions {
    std::string tests;
    bool markdown = false;
};

struct BenchmarkShowOptions : CommandOptions {
    std::string problem;
    bool markdown = false;
    bool case_alone = false;
};

/// Whether one text is in the other, letters large or small.
bool contains_word(const std::string& text, const std::string& word) {
    const auto alike = [](unsigned char a, unsigned char b) {
        return std::tolower(a) == std::tolower(b);
    };
    return std::ranges::search(text, word, alike).begin() != text.end();
}

std::vector<const Problem*> problems_that_test(const std::string& word) {
    std::vector<const Problem*> found;
    for (const Problem& problem : benchmarks::catalogue())
        if (contains_word(problem.tests, word) || contains_word(problem.title, word) ||
            contains_word(problem.group, word) || contains_word(problem.name, word))
            found.push_back(&problem);
    if (found.empty())
        throw contact::InputError("--tests " + io::shortened(word, 60) +
                                  ": no problem tests it; tricontact benchmark list shows all");
    return found;
}

void list_problems(const BenchmarkListOptions& options) {
    const auto problems = problems_that_test(options.tests);
    options.out() << (options.json       ? benchmarks::catalogue_json(problems)
                      : options.markdown ? benchmarks::catalogue_markdown(problems)
                                         : benchmarks::catalogue_text(problems));
}

/// The reference of a problem, or why there is none.
struct FoundReference {
    std::optional<benchmarks::Reference> reference;
    std::string why_not = {};
};

FoundReference reference_of(const Problem& problem, const CommandOptions& options) {
    if (!problem.has_case()) return {{}, "The closed forms below are the reference."};
    try {
        return {reference_of_case(problem.make_case(), options.threads, contact::silent)};
    } catch (const contact::InputError& error) {
        std::string text = error.what();
        constexpr std::string_view speaker = "reference: ";
        if (text.starts_with(speaker)) text.erase(0, speaker.size());
        return {{}, "No reference is computed: " + text + '.'};
    }
}

void show_problem(const BenchmarkShowOptions& options) {
    const Problem& problem = benchmarks::required_problem(options.problem);
    if (options.case_alone) {
        problem.make_case();
        options.out() << problem.case_text;
        return;
    }
    const FoundReference found = reference_of(problem, options);
    const ProblemFindings findings{.reference = found.reference ? &*found.reference : nullptr,
                                   .no_reference = found.why_not};
    options.out() << (options.json       ? benchmarks::problem_json(problem, findings)
                      : options.markdown ? benchmarks::problem_markdown(problem, findings)
                                         : benchmarks::problem_text(problem, findings));
}

}  // namespace

Command benchmark_command() {
    const auto none = [](const CommandOptions&) {
        throw contact::InputError(
            "benchmark: no part is given; begin with tricontact benchmark list (tricontact "
            "benchmark --help)");
    };
    return Declared<CommandOptions>(
        Group::trust, "benchmark",
        "Problems for contact codes, with references: list, show, deck, compare", none);
}

Command benchmark_list_command() {
    return Declared<BenchmarkListOptions>(Group::trust, "benchmark list",
                                          "List the problems for contact codes", list_problems)
        .option("--tests", &BenchmarkListOptions::tests,
                "Only problems whose name, title, group or tests have this word", "WORD")
        .json("As JSON")
        .flag("--markdown", &BenchmarkListOptions::markdown, "As a table in Markdown");
}

Command benchmark_show_command() {
    return Declared<BenchmarkShowOptions>(Group::trust, "benchmark show",
                                          "Show a problem: case, reference, published numbers",
                                          show_problem)
        .required("problem", &BenchmarkShowOptions::problem,
                  "Name of the problem; tricontact benchmark list names all", "NAME")
        .flag("--case", &BenchmarkShowOptions::case_alone, "The case file alone")
        .json("As JSON, numbers in SI units")
        .flag("--markdown", &BenchmarkShowOptions::markdown, "As a page in Markdown");
}

}  // namespace tricontact::app

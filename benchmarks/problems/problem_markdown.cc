#include <fmt/format.h>

#include <algorithm>

#include "benchmarks/problems/problem_numbers.h"
#include "benchmarks/problems/problem_page.h"

namespace tricontact::benchmarks {

namespace {

/// A cell of a table ends at a bar.
std::string cell(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
    return out;
}

std::string number_table(const std::string& heading, const std::vector<NumberRow>& rows) {
    if (rows.empty()) return "";
    const bool has_remarks =
        std::ranges::any_of(rows, [](const NumberRow& row) { return !row.remark.empty(); });
    std::string out =
        fmt::format("\n## {}\n\n| Quantity | Value | Source |{}\n|---|---|---|{}\n", heading,
                    has_remarks ? " Why not this problem |" : "", has_remarks ? "---|" : "");
    for (const NumberRow& row : rows) {
        out += fmt::format("| {} | {} | {} |", cell(row.title), cell(row.value), cell(row.source));
        out += has_remarks ? " " + cell(row.remark) + " |\n" : "\n";
    }
    return out;
}

std::string bullets(const std::string& heading, const std::vector<std::string>& items) {
    if (items.empty()) return "";
    std::string out = "\n## " + heading + "\n\n";
    for (const std::string& item : items) out += "- " + item + '\n';
    return out;
}

std::string block(const std::string& language, const std::string& text) {
    return "```" + language + '\n' + text + (text.ends_with('\n') ? "" : "\n") + "```\n";
}

}  // namespace

std::string catalogue_markdown(const std::vector<const Problem*>& problems) {
    std::string out = "| Problem | Group | Decks | Tests |\n|---|---|---|---|\n";
    for (const Problem* one : problems)
        out +=
            fmt::format("| [{0}](benchmarks/{0}.md) | {1} | {2} | {3} |\n", one->name, one->group,
                        one->decks.empty() ? "–" : fmt::format("{}", fmt::join(one->decks, ", ")),
                        cell(one->tests));
    return out;
}

std::string problem_markdown(const Problem& problem, const ProblemFindings& findings) {
    std::string out = "# " + problem.title + "\n\n";
    out += fmt::format("`{}` of the [catalogue](../benchmarks.md), group {}. Tests {}.\n\n",
                       problem.name, problem.group, problem.tests);
    out += problem.text + (problem.text.ends_with('\n') ? "" : "\n");
    if (problem.twin) out += fmt::format("\nControl experiment: [{0}]({0}.md).\n", *problem.twin);
    if (problem.has_case()) out += "\n## Case\n\n" + block("toml", problem.case_text);
    if (findings.reference) {
        out += number_table("Reference", reference_rows(problem, *findings.reference));
        for (const std::string& remark : findings.reference->remarks) out += '\n' + remark + '\n';
    }
    if (!findings.no_reference.empty()) out += "\n## Reference\n\n" + findings.no_reference + '\n';
    out += number_table("Published, and closed forms", target_rows(problem, true));
    out += number_table("Published, of other problems", target_rows(problem, false));
    out += bullets("What can go wrong", problem.traps);
    std::string commands;
    for (const std::string& command : commands_of(problem)) commands += command + '\n';
    out += "\n## Commands\n\n" + block("text", commands);
    return out + bullets("Sources", problem.sources);
}

}  // namespace tricontact::benchmarks

#include "benchmarks/problems/problem_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "benchmarks/problems/problem_numbers.h"

namespace tricontact::benchmarks {

namespace {

constexpr std::size_t page_width = 100;

/// A paragraph in lines of the page, those behind the first indented likewise.
std::string wrapped(std::string_view paragraph, const std::string& first,
                    const std::string& indent) {
    std::string text = first;
    std::size_t column = first.size();
    bool is_first = true;
    while (!paragraph.empty()) {
        const std::size_t end = std::min(paragraph.find(' '), paragraph.size());
        const std::string_view word = paragraph.substr(0, end);
        paragraph.remove_prefix(std::min(end + 1, paragraph.size()));
        if (!is_first && column + 1 + word.size() > page_width) {
            text += '\n' + indent;
            column = indent.size();
        } else if (!is_first) {
            text += ' ';
            ++column;
        }
        text += word;
        column += word.size();
        is_first = false;
    }
    return text + '\n';
}

std::string paragraphs(const std::string& text) {
    std::string out;
    for (const std::string& one : lines_of(text)) out += one.empty() ? "\n" : wrapped(one, "", "");
    return out;
}

std::string indented(const std::string& text) {
    std::string out;
    for (const std::string& line : lines_of(text))
        out += line.empty() ? "\n" : "    " + line + '\n';
    return out;
}

std::string list(const std::string& heading, const std::vector<std::string>& items) {
    if (items.empty()) return "";
    std::string out = '\n' + heading + '\n';
    for (const std::string& item : items) out += wrapped(item, "  - ", "    ");
    return out;
}

std::string number_lines(const std::string& heading, const std::vector<NumberRow>& rows) {
    if (rows.empty()) return "";
    std::string out = '\n' + heading + '\n';
    for (const NumberRow& row : rows) {
        out += wrapped(row.source, fmt::format("  {:<34} {:<26} ", row.title, row.value), "      ");
        if (!row.remark.empty()) out += wrapped(row.remark, "      ", "      ");
    }
    return out;
}

nlohmann::ordered_json head_of(const Problem& problem) {
    return {{"name", problem.name},
            {"title", problem.title},
            {"group", problem.group},
            {"tests", problem.tests},
            {"decks", problem.decks},
            {"twin", problem.twin ? nlohmann::ordered_json(*problem.twin) : nullptr}};
}

}  // namespace

std::string catalogue_text(const std::vector<const Problem*>& problems) {
    std::string out;
    for (const Problem* one : problems) {
        const std::string decks =
            one->decks.empty() ? "-" : fmt::format("{}", fmt::join(one->decks, ", "));
        out += fmt::format("{:<36} {:<10} {:<18} {}\n", one->name, one->group, decks, one->tests);
    }
    return fmt::format("{:<36} {:<10} {:<18} {}\n", "problem", "group", "decks", "tests") + out;
}

std::string catalogue_json(const std::vector<const Problem*>& problems) {
    auto all = nlohmann::ordered_json::array();
    for (const Problem* one : problems) all.push_back(head_of(*one));
    return all.dump(2) + '\n';
}

std::string problem_text(const Problem& problem, const ProblemFindings& findings) {
    std::string out =
        problem.title + '\n' +
        wrapped(fmt::format("{}: {}; tests {}", problem.name, problem.group, problem.tests), "",
                "");
    out += '\n' + paragraphs(problem.text);
    if (problem.twin) out += '\n' + wrapped("Control experiment: " + *problem.twin, "", "");
    if (problem.has_case()) out += "\nCase\n" + indented(problem.case_text);
    if (findings.reference)
        out += number_lines("Reference", reference_rows(problem, *findings.reference));
    if (findings.reference)
        for (const std::string& remark : findings.reference->remarks)
            out += wrapped(remark, "  ", "  ");
    if (!findings.no_reference.empty()) out += '\n' + wrapped(findings.no_reference, "", "");
    out += number_lines("Published, and closed forms", target_rows(problem, true));
    out += number_lines("Published, of other problems", target_rows(problem, false));
    out += list("What can go wrong", problem.traps);
    out += "\nCommands\n";
    for (const std::string& command : commands_of(problem)) out += "  " + command + '\n';
    return out + list("Sources", problem.sources);
}

std::string problem_json(const Problem& problem, const ProblemFindings& findings) {
    nlohmann::ordered_json json = head_of(problem);
    json["text"] = problem.text;
    json["case"] = problem.has_case() ? nlohmann::ordered_json(problem.case_text) : nullptr;
    json["reference"] = nullptr;
    if (findings.reference) {
        auto quantities = nlohmann::ordered_json::object();
        for (const auto& [key, value] : findings.reference->values)
            quantities[key] = {{"value", value.value},
                               {"bar", value.bar()},
                               {"source", value.source},
                               {"prescribed", findings.reference->is_prescribed(key)}};
        json["reference"] = {{"models", findings.reference->models},
                             {"quantities", quantities},
                             {"remarks", findings.reference->remarks}};
    }
    if (!findings.no_reference.empty()) json["no_reference"] = findings.no_reference;
    json["targets"] = nlohmann::ordered_json::array();
    for (const Target& target : problem.targets) {
        nlohmann::ordered_json one{{"quantity", target.key},        {"title", target.title},
                                   {"value", target.value},         {"bar", target.bar},
                                   {"unit", target.unit},           {"source", target.source},
                                   {"solution", target.is_solution}};
        if (!target.remark.empty()) one["remark"] = target.remark;
        json["targets"].push_back(one);
    }
    json["traps"] = problem.traps;
    json["sources"] = problem.sources;
    return json.dump(2) + '\n';
}

}  // namespace tricontact::benchmarks

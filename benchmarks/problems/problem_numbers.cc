#include "benchmarks/problems/problem_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "benchmarks/reference/quantity_units.h"
#include "report/format.h"

namespace tricontact::benchmarks {

namespace {

/// In a unit of this size.
std::string number_with_bar(double value, double bar, double size, std::string_view unit) {
    constexpr double nothing = 1e-6;  // of the value: beyond the digits that are shown
    const std::string number = bar > nothing * std::abs(value)
                                   ? report::with_error(value / size, bar / size)
                                   : report::as_given(value / size);
    return unit.empty() ? number : number + ' ' + std::string(unit);
}

}  // namespace

std::vector<NumberRow> target_rows(const Problem& problem, bool is_solution) {
    std::vector<NumberRow> rows;
    for (const Target& one : problem.targets)
        if (one.is_solution == is_solution)
            rows.push_back({one.title, number_with_bar(one.value, one.bar, one.unit_size, one.unit),
                            one.source, one.remark});
    return rows;
}

std::vector<NumberRow> reference_rows(const Problem& problem, const Reference& reference) {
    std::vector<NumberRow> rows;
    for (const std::string_view shown : shown_quantities()) {
        const std::string key(shown);
        const ReferenceValue* found = reference.find(key);
        if (!found || reference.is_prescribed(key)) continue;
        const ReferenceValue& value = *found;
        const auto target = std::ranges::find(problem.targets, key, &Target::key);
        const QuantityUnit* unit =
            target == problem.targets.end() ? nullptr : find_unit(target->unit);
        if (!unit) unit = &usual_unit(key, reference.geometry);
        rows.push_back({std::string(title_of_quantity(key)),
                        number_with_bar(value.value, value.bar(), unit->size, unit->word),
                        value.source});
    }
    return rows;
}

std::vector<std::string> commands_of(const Problem& problem) {
    std::vector<std::string> commands{"tricontact benchmark show " + problem.name};
    if (problem.has_case()) {
        commands.push_back(
            fmt::format("tricontact benchmark show {0} --case >{0}.toml", problem.name));
        commands.push_back(fmt::format("tricontact run {}.toml", problem.name));
    }
    if (!problem.decks.empty()) {
        commands.push_back(
            fmt::format("tricontact benchmark deck {} --code calculix --output try", problem.name));
        if (problem.has_case())
            commands.emplace_back("tricontact benchmark compare try/submission.toml");
    }
    commands.push_back(fmt::format(
        "tricontact benchmark compare --case {} coarse.csv medium.csv fine.csv", problem.name));
    return commands;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

}  // namespace tricontact::benchmarks

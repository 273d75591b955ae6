// Tables that tell laws of friction apart: sentence, table and JSON.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "experiments/design/design_report.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

using report::quantity;

std::string percent_of(const PlannedRow& row) {
    return report::significant(100 * row.standard_error / row.value, 2) + " %";
}

/// "static shifts of 12.1 um, 5.2 um (2 % each)".
std::string rows_text(const LawSeparation& separation, std::string_view name) {
    std::vector<std::string> texts;
    std::string error;
    for (const PlannedRow& row : separation.rows) {
        if (row.quantity != name) continue;
        error = percent_of(row);
        const std::string value = quantity(row.value, row.unit, 3),
                          load = quantity(row.normal_force, "N", 3);
        texts.push_back(row.tangential_force > 0
                            ? fmt::format("{} under F_T = {} and F_N = {}", value,
                                          quantity(row.tangential_force, "N", 3), load)
                            : fmt::format("{} under F_N = {}", value, load));
    }
    if (texts.empty()) return "";
    return fmt::format("{} (standard error {}): {}", name, error, fmt::join(texts, ", "));
}

}  // namespace

std::string planned_sentence(const DesignStudy& study) {
    std::vector<std::string> kinds;
    for (const char* name : {"sliding force", "static shift", "limit of shakedown"})
        if (std::string text = rows_text(*study.separation, name); !text.empty())
            kinds.push_back(std::move(text));
    return fmt::format("To be measured there, with what {} gives: {}.",
                       study.input.at(study.solution.best.fractions).c.friction.formula(),
                       fmt::join(kinds, "; "));
}

report::DocumentTable planned_table(const DesignStudy& study) {
    report::DocumentTable table{
        .id = "planned",
        .title = "Tables that tell the laws apart",
        .note =
            "By closed forms of the half-space. Behind each other law: how far the value is "
            "from that law with the numbers that explain all rows best, in standard errors; D "
            "is the root of the sum of their squares, stated numbers of the case included.",
        .columns = report::columns("quantity", "F_N [N]", "F_T [N]", "value [N, µm]",
                                   "standard error [%]:2")};
    for (const std::string& law : study.input.laws.laws)
        table.columns.push_back(report::column(law + ":3"));
    for (const PlannedRow& row : study.separation->rows) {
        const double unit = row.unit == std::string("m") ? 1e-6 : 1;
        table.rows.push_back(
            {std::string(row.quantity), row.normal_force,
             report::number_cell(row.tangential_force > 0 ? std::optional(row.tangential_force)
                                                          : std::nullopt),
             row.value / unit, 100 * row.standard_error / row.value});
        for (const double off : row.off) table.rows.back().push_back(off);
    }
    return table;
}

nlohmann::ordered_json separation_json(const DesignStudy& study) {
    using Json = nlohmann::ordered_json;
    if (!study.separation) return {};
    const auto& laws = study.input.laws.laws;
    Json distances = Json::object(), rows = Json::array();
    for (std::size_t i = 0; i < laws.size(); ++i)
        distances[laws[i]] = study.separation->distances[i];
    for (const PlannedRow& row : study.separation->rows) {
        Json off = Json::object();
        for (std::size_t i = 0; i < laws.size(); ++i) off[laws[i]] = row.off[i];
        rows.push_back(
            {{"quantity", row.quantity},
             {comparisons::quantities::normal_force.key, row.normal_force},
             {"tangential_force_N", row.tangential_force > 0 ? Json(row.tangential_force) : Json()},
             {"value", row.value},
             {"standard_error", row.standard_error},
             {"unit", row.unit},
             {"off_in_standard_errors", off}});
    }
    return {{"at_least", told_distance}, {"distances", distances}, {"rows", rows}};
}

}  // namespace tricontact::experiments

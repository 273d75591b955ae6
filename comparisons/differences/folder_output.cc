// Two folders of results as JSON and on a terminal.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/differences/folder_tables.h"
#include "report/format.h"
#include "report/json_number.h"
#include "report/table_text.h"

namespace tricontact::comparisons {

namespace {

using json = nlohmann::ordered_json;

json number_pair_json(const NumberPair& one) {
    const auto overlap = one.overlaps();
    const bool both = one.a && one.b;
    return {{"a", report::number(one.a)},
            {"b", report::number(one.b)},
            {"difference", both ? report::number(*one.a - *one.b) : json()},
            {"relative", report::number(one.relative())},
            {"bar_a", report::number(one.bar_a)},
            {"bar_b", report::number(one.bar_b)},
            {"bars_overlap", overlap ? json(*overlap) : json()}};
}

json largest_json(const LargestDifference& one) {
    return {{"largest_Pa", report::number(one.value)},
            {"x_m", report::number(one.place[0])},
            {"y_m", report::number(one.place[1])},
            {"over_Pa", report::number(one.over)},
            {"l2", report::number(one.l2)}};
}

json instant_json(const InstantDifference& one) {
    return {{"time", one.time},
            {"pressure", largest_json(one.pressure)},
            {"traction", largest_json(one.traction)}};
}

json pair_json(const RunPair& pair) {
    json numbers = json::object(), curves = json::object();
    for (const NumberPair& one : pair.numbers) numbers[one.key] = number_pair_json(one);
    for (const CurvePair& curve : pair.curves) {
        double largest = 0, at = 0;
        for (std::size_t k = 0; k < curve.phase.size(); ++k)
            if (const double apart = curve.a[k] - curve.b[k]; std::abs(apart) > std::abs(largest))
                largest = apart, at = curve.phase[k];
        curves[curve.column] = {{"largest", report::number(largest)}, {"phase", at}};
    }
    return {{"a", pair.model_a},
            {"b", pair.model_b},
            {"state_a", pair.state_a.empty() ? json() : json(pair.state_a)},
            {"state_b", pair.state_b.empty() ? json() : json(pair.state_b)},
            {"quantities", numbers},
            {"history", curves},
            {"fields", report::list_of(pair.instants, instant_json)},
            {"why_no_fields", pair.why_no_fields.empty() ? json() : json(pair.why_no_fields)}};
}

json change_json(const ChangedKey& one) {
    const auto value = [](const std::string& text) { return text.empty() ? json() : json(text); };
    return {{"key", one.key}, {"a", value(one.a)}, {"b", value(one.b)}};
}

}  // namespace

json folder_json(const std::string& version, const FolderComparison& comparison) {
    return {{"version", version},
            {"a", {{"folder", comparison.path_a}, {"version", comparison.version_a}}},
            {"b", {{"folder", comparison.path_b}, {"version", comparison.version_b}}},
            {"case_differences", report::list_of(comparison.changes, change_json)},
            {"pairs", report::list_of(comparison.pairs, pair_json)},
            {"notes", comparison.notes}};
}

std::string folder_text(const FolderComparison& comparison) {
    std::string text = fmt::format("A: {}\nB: {}\n\n", comparison.path_a, comparison.path_b);
    text += comparison.changes.empty() ? "the cases are the same\n"
                                       : report::table_text(change_table(comparison));
    for (const std::string& note : comparison.notes) text += note + '\n';
    for (const RunPair& pair : comparison.pairs) {
        text += fmt::format("\n{} minus {}", pair.title_a(), pair.title_b());
        if (!pair.state_a.empty() || !pair.state_b.empty())
            text += fmt::format("; verdict {} and {}", pair.state_a, pair.state_b);
        text += '\n' + report::table_text(number_table(pair, false));
        if (!pair.why_no_fields.empty())
            text += "fields: not compared, " + pair.why_no_fields + '\n';
    }
    const report::DocumentTable fields = folder_field_table(comparison);
    if (!fields.rows.empty()) text += '\n' + report::table_text(fields);
    return text;
}

}  // namespace tricontact::comparisons

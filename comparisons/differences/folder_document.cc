// Two folders of results as a report.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/differences/folder_tables.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using Standing = report::Verdict::Standing;

/// "55.9 µm": units of one letter take prefixes.
std::string value_with_unit(std::optional<double> value, const std::string& unit) {
    if (!value || !std::isfinite(*value)) return report::significant({});
    constexpr std::array bases{"m", "N", "Pa", "J", "s"};
    if (std::ranges::find(bases, unit) != bases.end() && *value != 0)
        return report::quantity(*value, unit, 5);
    if (unit.empty() && *value == std::round(*value)) return report::as_given(*value);
    return report::significant(*value, 5) + (unit.empty() ? "" : ' ' + unit);
}

std::string bar_text(std::optional<double> bar, std::optional<double> value) {
    if (!bar || !value) return "";
    return *value == 0 ? report::significant(*bar, 2) : report::share(*bar / std::abs(*value));
}

std::vector<report::Figure> curve_figures(const RunPair& pair, const std::string& id) {
    std::vector<report::Figure> figures;
    for (const CurvePair& curve : pair.curves) {
        double largest = 0, apart = 0;
        std::vector<double> apart_by;
        for (std::size_t k = 0; k < curve.phase.size(); ++k) {
            apart_by.push_back(curve.a[k] - curve.b[k]);
            largest = std::max({largest, std::abs(curve.a[k]), std::abs(curve.b[k])});
            apart = std::max(apart, std::abs(curve.a[k] - curve.b[k]));
        }
        // What varies by less is held by the load to the accuracy of the solvers.
        const double least = 1e-6 * largest;
        const auto varies = [least](const std::vector<double>& values) {
            const auto [low, high] = std::ranges::minmax(values);
            return high - low > least;
        };
        if (!(apart > least) && !varies(curve.a)) continue;
        const report::Unit unit = report::fitting_unit(largest, curve.unit);
        const report::Unit fine = report::fitting_unit(apart > 0 ? apart : largest, curve.unit);
        report::Figure values{.id = fmt::format("{}_{}", curve.column, id),
                              .title = report::capitalised(curve.label) + " over the phase",
                              .caption = "At the steps of A that B reaches too.",
                              .x = {"phase n [periods or rows]"},
                              .y = {fmt::format("{} [{}]", curve.label, unit.symbol)}};
        report::Figure differences = values;
        differences.id = fmt::format("{}_difference_{}", curve.column, id);
        differences.title = fmt::format("Difference of the {}", curve.label);
        differences.caption = "A minus B; between the steps of B on a straight line.";
        differences.y = {fmt::format("A minus B [{}]", fine.symbol)};
        report::Curve a{.name = pair.title_a()}, b{.name = pair.title_b()}, d{.name = "A minus B"};
        for (std::size_t k = 0; k < curve.phase.size(); ++k) {
            a.add(curve.phase[k], curve.a[k] / unit.factor);
            b.add(curve.phase[k], curve.b[k] / unit.factor);
            d.add(curve.phase[k], (curve.a[k] - curve.b[k]) / fine.factor);
        }
        values.curves = {std::move(a), std::move(b)};
        differences.curves = {std::move(d)};
        figures.push_back(std::move(values));
        if (varies(apart_by)) figures.push_back(std::move(differences));
    }
    return figures;
}

std::optional<report::Figure> instants_figure(const RunPair& pair, const std::string& id) {
    if (pair.instants.size() < 2) return {};
    report::Figure figure{.id = "instants_" + id,
                          .title = "Fields at common instants",
                          .caption = "Root of the mean square of A minus B over that of B.",
                          .x = {"time of the series [periods, rows or seconds]"},
                          .y = {"L2 of the difference [%]"}};
    report::Curve p{.name = "pressure", .kind = report::Curve::Kind::line_and_points},
        t{.name = "traction", .kind = report::Curve::Kind::line_and_points};
    for (const InstantDifference& one : pair.instants) {
        p.add(one.time, 100 * one.pressure.l2);
        if (one.traction.over > 0) t.add(one.time, 100 * one.traction.l2);
    }
    figure.curves = {std::move(p)};
    if (!t.x.empty()) figure.curves.push_back(std::move(t));
    return figure;
}

report::DocumentSection pair_section(const RunPair& pair) {
    const std::string id = report::id_of_model(pair.id());
    report::DocumentSection section{
        .id = "pair_" + id,
        .heading = fmt::format("{} minus {}", pair.title_a(), pair.title_b()),
        .figures = curve_figures(pair, id),
        .tables = {number_table(pair, false)},
        .open = true};
    if (auto lists = number_table(pair, true); !lists.rows.empty())
        section.tables.push_back(std::move(lists));
    if (!pair.why_no_fields.empty())
        section.paragraphs.push_back(
            fmt::format("Fields were not compared: {}.", pair.why_no_fields));
    if (pair.last)
        for (report::Figure& figure : difference_figures(*pair.last, id))
            section.figures.push_back(std::move(figure));
    if (auto figure = instants_figure(pair, id)) section.figures.push_back(std::move(*figure));
    return section;
}

report::Verdict pair_verdict(const RunPair& pair) {
    const NumberPair* most = nullptr;
    int n_apart = 0, n_overlap = 0;
    for (const NumberPair& one : pair.numbers) {
        const auto overlap = one.overlaps();
        if (!overlap) continue;
        *overlap ? ++n_overlap : ++n_apart;
        if (*overlap || !one.relative()) continue;
        if (!most || std::abs(*one.relative()) > std::abs(*most->relative())) most = &one;
    }
    std::string text = fmt::format("{} minus {}: ", pair.title_a(), pair.title_b());
    if (n_apart + n_overlap == 0) {
        text +=
            "the numerical errors of both are not known, so that no difference is judged from "
            "them";
    } else {
        text += fmt::format("numerical bars overlap in {} of {} quantities", n_overlap,
                            n_apart + n_overlap);
        if (most)
            text += fmt::format("; farthest apart: {} by {}", most->label,
                                report::percent(1 + *most->relative()));
    }
    if (pair.state_a != pair.state_b)
        text += fmt::format("; the verdicts differ: {} and {}", pair.state_a, pair.state_b);
    return {Standing::finding, text + '.'};
}

}  // namespace

report::DocumentTable change_table(const FolderComparison& comparison) {
    report::DocumentTable table{.id = "case_differences",
                                .title = "What differs in the cases",
                                .columns = report::columns("key", "A", "B")};
    for (const ChangedKey& one : comparison.changes)
        table.rows.push_back({one.key, one.a.empty() ? "–" : one.a, one.b.empty() ? "–" : one.b});
    return table;
}

report::DocumentTable number_table(const RunPair& pair, bool lists) {
    report::DocumentTable table{
        .id = (lists ? "periods_" : "quantities_") + report::id_of_model(pair.id()),
        .title = lists ? "Numbers per period" : "Quantities side by side",
        .note =
            "difference: A over B minus 1. bars: numerical half widths of either over its "
            "value, where its run has estimated them.",
        .columns = {{"quantity"},
                    {"A"},
                    {"B"},
                    {.heading = "difference [%]", .digits = 3},
                    {"bar of A"},
                    {"bar of B"},
                    {"bars overlap"}},
        .folded = lists};
    for (const NumberPair& one : pair.numbers) {
        if (one.is_of_list != lists) continue;
        const auto overlap = one.overlaps();
        table.rows.push_back(
            {one.label, value_with_unit(one.a, one.unit), value_with_unit(one.b, one.unit),
             report::number_cell(one.relative(), .01), bar_text(one.bar_a, one.a),
             bar_text(one.bar_b, one.b), overlap ? (*overlap ? "yes" : "no") : ""});
    }
    return table;
}

report::DocumentTable folder_field_table(const FolderComparison& comparison) {
    std::vector<SurfaceDifference> differences;
    for (const RunPair& pair : comparison.pairs)
        if (pair.last) differences.push_back(*pair.last);
    return difference_table(differences);
}

report::Document folder_document(const FolderComparison& comparison) {
    report::Document document{
        .kind = "Two runs",
        .title = fmt::format("{} and {}", comparison.path_a, comparison.path_b),
        .lead = "A is the first folder, B the second one; differences are A minus B.",
        .settings = {{"A", comparison.path_a + ", version " + comparison.version_a},
                     {"B", comparison.path_b + ", version " + comparison.version_b}},
        .files = {{"all numbers (JSON)", "compare.json"}}};
    if (!comparison.changes.empty())
        document.comparison = change_table(comparison);
    else
        document.verdicts.push_back({Standing::finding, "The cases are the same."});
    for (const RunPair& pair : comparison.pairs) document.verdicts.push_back(pair_verdict(pair));
    for (const std::string& note : comparison.notes)
        document.verdicts.push_back({Standing::finding, note});
    for (const RunPair& pair : comparison.pairs) document.sections.push_back(pair_section(pair));
    if (auto fields = folder_field_table(comparison); !fields.rows.empty())
        document.sections.push_back({.id = "fields",
                                     .heading = "Fields at the last common instant",
                                     .tables = {std::move(fields)},
                                     .open = true});
    return document;
}

}  // namespace tricontact::comparisons

#include "comparisons/run/sweep_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "comparisons/run/input_reading.h"

namespace tricontact::comparisons {

namespace {

constexpr std::size_t most_rows = 300;  // of a table in the page; the CSV has all

/// "4 ... 32 mm, 4 values".
std::string range_of(const Sweep& sweep, std::size_t axis, const SweepScale& scale) {
    if (!scale.is_number) {
        std::set<std::string> words;
        for (const Sweep::Point& point : sweep.points)
            if (const auto* word = std::get_if<std::string>(&point.values[axis]))
                words.insert(*word);
        return fmt::format("{}", fmt::join(words, ", "));
    }
    if (scale.values.empty()) return "no values";
    const std::string unit = scale.unit.symbol.empty() ? "" : " " + scale.unit.symbol;
    const std::string first = report::as_given(*scale.values.begin());
    if (scale.values.size() == 1) return first + unit;
    return fmt::format("{} ... {}{}, {} values", first, report::as_given(*scale.values.rbegin()),
                       unit, scale.values.size());
}

/// What `plotted` quantities some point knows.
std::vector<const Quantity*> shown_quantities(const Sweep& sweep) {
    std::vector<const Quantity*> shown;
    for (const Quantity* q : all_quantities())
        if (q->is_plotted && std::ranges::any_of(sweep.points, [q](const Sweep::Point& p) {
                return p.results.told(*q).has_value();
            }))
            shown.push_back(q);
    return shown;
}

/// Of rolling, or the regime of a path's closed cycles; empty without either.
std::string state_of(const Sweep::Point& point) {
    if (const auto state = point.results.state()) return contact::name_of(*state);
    const auto* regime = std::get_if<SlipRegime>(&point.results[quantities::path_regime]);
    return regime ? name_of(*regime) : "";
}

/// All points with their results, or the first of those that failed with their errors.
report::DocumentTable table_of(const Sweep& sweep, const std::vector<SweepScale>& scales,
                               bool failures) {
    const std::vector<const Quantity*> shown = shown_quantities(sweep);
    report::DocumentTable table{.id = failures ? "failed_points" : "points",
                                .title = failures ? "Points that failed" : "Points",
                                .columns = {{"model"}},
                                .rows = {}};
    for (const SweepScale& scale : scales) table.columns.push_back({scale.heading});
    table.columns.push_back({failures ? "error" : quantities::state.key});
    if (!failures)
        for (const Quantity* q : shown) table.columns.push_back({heading_of(*q)});
    const bool has_files = !failures && std::ranges::any_of(sweep.points, [](const auto& p) {
        return !p.surface.empty();
    });
    if (has_files) table.columns.push_back({"ParaView"});
    for (const Sweep::Point& point : sweep.points) {
        if (failures && (!point.error || table.rows.size() == most_rows)) continue;
        std::vector<report::Cell>& row = table.rows.emplace_back();
        row.emplace_back(name_of(point, sweep));
        for (std::size_t i = 0; i < scales.size(); ++i) {
            const auto* number = std::get_if<double>(&point.values[i]);
            row.push_back(number ? report::number_cell(*number, scales[i].unit.factor)
                                 : point.values[i]);
        }
        row.emplace_back(failures ? *point.error : state_of(point));
        if (!failures)
            for (const Quantity* q : shown) row.emplace_back(point.results.told(*q).value_or(NAN));
        if (has_files)
            row.push_back(point.surface.empty()
                              ? report::Cell("")
                              : report::Cell(report::Link{"surface", point.surface}));
    }
    return table;
}

std::size_t failures_of(const Sweep& sweep) {
    return std::ranges::count_if(sweep.points, [](const auto& p) { return p.error.has_value(); });
}

std::vector<report::Verdict> verdicts_of(const Sweep& sweep) {
    const std::size_t n = sweep.points.size();
    const std::size_t n_failed = failures_of(sweep);
    const std::string counted = fmt::format("{} {}", n, n == 1 ? "point" : "points");
    std::vector<report::Verdict> verdicts;
    if (n_failed == 0)
        verdicts.push_back({report::Verdict::Standing::pass, counted + " computed, none failed."});
    else
        verdicts.push_back(
            {report::Verdict::Standing::fail, fmt::format("{} of {} failed.", n_failed, counted)});
    using enum contact::State;
    std::vector<std::string> models;
    std::map<std::string, std::map<contact::State, int>> states;
    for (const Sweep::Point& point : sweep.points) {
        const auto state = point.results.state();
        if (!state) continue;
        if (!states.contains(point.model)) models.push_back(point.model);
        ++states[point.model][*state];
    }
    for (const std::string& model : models) {
        auto& of_model = states[model];
        const int n_rolling = of_model[shakedown] + of_model[cyclic_slip] + of_model[ratcheting] +
                              of_model[undecided];
        std::string text =
            fmt::format("{}: of {} rolling {}, {} shake down, ", report::display_name(model),
                        n_rolling, n_rolling == 1 ? "point" : "points", of_model[shakedown]);
        if (of_model[cyclic_slip] > 0)
            text += fmt::format("{} end in cyclic slip, ", of_model[cyclic_slip]);
        text += fmt::format("{} ratchet, {} stay undecided.", of_model[ratcheting],
                            of_model[undecided]);
        verdicts.push_back({report::Verdict::Standing::finding, text});
    }
    std::vector<const Results*> results;
    for (const Sweep::Point& point : sweep.points)
        if (!point.error) results.push_back(&point.results);
    if (const std::string warning = border_warning(results); !warning.empty())
        verdicts.push_back({report::Verdict::Standing::violated,
                            "The height map is larger than the contact: " + warning + "."});
    return verdicts;
}

report::DocumentSection points_section(const Sweep& sweep, const std::vector<SweepScale>& scales) {
    report::DocumentSection section{.id = "points", .heading = "All points"};
    if (sweep.points.size() <= most_rows) {
        section.tables.push_back(table_of(sweep, scales, false));
        section.tables.back().note =
            "Ratios are over each model's own U_max. Undefined values are left empty: a contact "
            "that "
            "ratchets has no settled shift.";
    } else {
        section.paragraphs.push_back(fmt::format(
            "{} points are too many for a page: results.csv has them all.", sweep.points.size()));
    }
    const std::size_t n_failed = failures_of(sweep);
    if (n_failed == 0) return section;
    section.tables.push_back(table_of(sweep, scales, true));
    if (n_failed > most_rows)
        section.tables.back().note = fmt::format("The first {} of {}.", most_rows, n_failed);
    return section;
}

}  // namespace

report::Document sweep_document(const Sweep& sweep) {
    const std::vector<SweepScale> scales = scales_of(sweep);
    report::Document document{.kind = "Sweep", .title = sweep.title};
    document.verdicts = verdicts_of(sweep);
    document.settings = sweep.settings;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
        document.settings.emplace_back(sweep.axes[i].key, range_of(sweep, i, scales[i]));
    document.sections = shift_sections(sweep, scales);
    std::vector<report::Figure> maps = regime_maps(sweep, scales);
    if (maps.empty()) {
        document.figure = opening_figure(document.sections);
    } else {
        document.figure = std::move(maps.front());
        maps.erase(maps.begin());
    }
    if (document.figure)  // which stands nowhere twice
        for (report::DocumentSection& section : document.sections)
            std::erase_if(section.figures, [&](const report::Figure& figure) {
                return figure.id == document.figure->id;
            });
    if (!maps.empty())
        document.sections.insert(
            document.sections.begin(),
            {.id = "regimes", .heading = "Regimes", .figures = std::move(maps)});
    document.sections.push_back(points_section(sweep, scales));
    if (sweep.points.size() > most_drawn)
        document.sections.back().paragraphs.push_back(
            fmt::format("Figures are drawn of at most {} points.", most_drawn));
    return document;
}

}  // namespace tricontact::comparisons

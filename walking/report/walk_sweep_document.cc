#include "walking/report/walk_sweep_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace tricontact::walking {

namespace {

constexpr std::size_t most_rows = 300;  // of a table in the page; the CSV has all

report::Verdict count_verdict(const WalkSweep& sweep) {
    const std::size_t n = sweep.points.size();
    const auto n_failed = std::ranges::count_if(
        sweep.points, [](const WalkSweep::Point& point) { return !point.outcome; });
    if (n_failed > 0)
        return {report::Verdict::Standing::fail, fmt::format("{} of {} runs failed.", n_failed, n)};
    return {report::Verdict::Standing::pass, fmt::format("{} runs computed, none failed.", n)};
}

report::Verdict regime_verdict(const WalkSweep& sweep) {
    using enum Regime;
    std::map<Regime, int> n;
    int n_short = 0;
    for (const WalkSweep::Point& point : sweep.points) {
        if (!point.outcome) continue;
        const WalkResult& result = point.outcome->result;
        ++n[result.regime];
        n_short += result.regime != tilting && !result.transient_over;
    }
    if (n[steady] + n[limit_cycle] + n[chaotic] + n[sticking] == 0)
        return {.sentence =
                    fmt::format("{} runs shake down, {} ratchet, {} walk, {} tilt.", n[shakedown],
                                n[ratcheting], n[Regime::walking], n[tilting])};
    const std::string loading =
        n[sticking] > 0
            ? fmt::format(" {} do not slide yet, the base still loads their spring.", n[sticking])
            : "";
    return {.sentence =
                fmt::format("{} runs slide steadily, {} walk in a limit cycle, {} are chaotic to "
                            "their end, {} tilt.{} Of those that do not tilt, {} are too short to "
                            "decide whether their transient is over.",
                            n[steady], n[limit_cycle], n[chaotic], n[tilting], loading, n_short)};
}

report::DocumentTable run_table(const WalkSweep& sweep) {
    report::DocumentTable table{.id = "runs",
                                .title = "Runs",
                                .note =
                                    "After the transient; over whole periods of limit cycles. "
                                    "results.csv has all numbers."};
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
        table.columns.push_back({label_of(sweep, i)});
    for (const char* heading : {"regime", "μ_e", "period", "z_min/z_stat", "t_s1", "t_s2"})
        table.columns.push_back({heading});
    for (const WalkSweep::Point& point : sweep.points) {
        if (!point.outcome) continue;
        const WalkResult& result = point.outcome->result;
        std::vector<report::Cell>& row = table.rows.emplace_back();
        for (std::size_t i = 0; i < sweep.axes.size(); ++i)
            row.push_back(shown_cell(sweep, i, point.values[i]));
        row.insert(row.end(), {std::string(word_of(result.regime)),
                               report::WithError{result.mu_e, result.mu_e_error},
                               result.period.value_or(NAN), result.z_min_ratio,
                               result.spots.front().stick_time, result.spots.back().stick_time});
    }
    return table;
}

report::DocumentTable failure_table(const WalkSweep& sweep) {
    report::DocumentTable table{.id = "failed_runs", .title = "Runs that failed"};
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
        table.columns.push_back({label_of(sweep, i)});
    table.columns.push_back({"error"});
    for (const WalkSweep::Point& point : sweep.points) {
        if (point.outcome || table.rows.size() == most_rows) continue;
        table.rows.emplace_back(point.values).emplace_back(point.error);
    }
    return table;
}

report::DocumentSection runs_section(const WalkSweep& sweep) {
    report::DocumentSection section{.id = "all_runs", .heading = "All runs"};
    if (sweep.points.size() <= most_rows)
        section.tables.push_back(run_table(sweep));
    else
        section.paragraphs.push_back(fmt::format(
            "{} runs are too many for a page: results.csv has them all.", sweep.points.size()));
    report::DocumentTable failed = failure_table(sweep);
    if (!failed.rows.empty()) section.tables.push_back(std::move(failed));
    return section;
}

std::vector<WalkSection> sections_of(const WalkSweep& sweep) {
    const std::vector<WalkGroup> groups = groups_of(sweep);
    if (groups.empty()) return {};
    if (auto compared = scenarios_section(sweep)) return {*compared};
    if (auto starts = starts_section(sweep)) return {*starts};
    if (const auto grid = grid_of(sweep, groups)) return {map_section(sweep, *grid)};
    std::vector<WalkSection> sections;
    if (auto effects = effects_section(sweep, groups)) sections.push_back(*effects);
    if (auto curves = curves_section(sweep, groups)) sections.push_back(*curves);
    return sections;
}

}  // namespace

report::Document walk_sweep_document(const WalkSweep& sweep) {
    report::Document document{.kind = "Study of walking machines", .title = sweep.title};
    document.verdicts = {count_verdict(sweep), regime_verdict(sweep)};
    document.settings = sweep.settings;
    for (const WalkSection& each : sections_of(sweep)) {
        document.verdicts.insert(document.verdicts.end(), each.verdicts.begin(),
                                 each.verdicts.end());
        document.sections.push_back(each.section);
    }
    document.sections.push_back(runs_section(sweep));
    return document;
}

std::optional<WalkMap> walk_map_of(const WalkSweep& sweep) {
    const std::vector<WalkGroup> groups = groups_of(sweep);
    const auto grid = grid_of(sweep, groups);
    if (!grid || label_of(sweep, grid->x_axis) != "κ_8" || label_of(sweep, grid->y_axis) != "μ")
        return {};
    WalkMap map{.title = sweep.title,
                .machine = groups.front().machine(),
                .kappa8 = grid->x,
                .friction = grid->y,
                .cells = {},
                .settings = sweep.settings};
    for (const WalkGroup* cell : grid->cells) {
        if (!cell || cell->points.front()->outcome->result.drift) return {};
        map.cells.push_back(*cell->points.front()->outcome);
    }
    return map;
}

}  // namespace tricontact::walking

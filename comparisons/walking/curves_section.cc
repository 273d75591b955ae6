#include <fmt/format.h>

#include <cmath>
#include <map>

#include "comparisons/format.h"
#include "comparisons/walking/walk_sections.h"

namespace tricontact::comparisons::walking {

namespace {

constexpr std::size_t most_curves = 8;

std::string shown(const WalkSweep& sweep, std::size_t axis, const Cell& value) {
    if (const auto* word = std::get_if<std::string>(&value)) return *word;
    return as_given(shown_value(sweep, axis, value));
}

/// "κ_8 = -0.47, μ = 0.75" of all axes but one.
std::string name_of(const WalkSweep& sweep, const std::vector<std::size_t>& axes,
                    const WalkGroup& group, std::size_t but) {
    std::string name;
    for (std::size_t k = 0; k < axes.size(); ++k) {
        if (k == but) continue;
        if (!name.empty()) name += ", ";
        name += label_of(sweep, axes[k]) + " = " + shown(sweep, axes[k], group.values[k]);
    }
    return name.empty() ? "μ_e" : name;
}

Figure figure_over(const WalkSweep& sweep, const std::vector<std::size_t>& axes, std::size_t over,
                   const std::vector<WalkGroup>& groups) {
    Figure figure{.id = fmt::format("friction_{}", over + 1),
                  .title = "Effective friction over " + label_of(sweep, axes[over]),
                  .caption =
                      "Bars: 95 %, from the scatter between the starts, else of the run "
                      "itself. Machines that tilt are left out.",
                  .x = {label_of(sweep, axes[over]), sweep.axes[axes[over]].logarithmic},
                  .y = {"μ_e"}};
    std::map<std::string, std::size_t> known;
    for (const WalkGroup& group : groups) {
        const std::string name = name_of(sweep, axes, group, over);
        const auto [at, is_new] = known.emplace(name, figure.curves.size());
        if (is_new)
            figure.curves.push_back(
                {.name = name, .x = {}, .y = {}, .kind = Curve::Kind::line_and_points});
        Curve& curve = figure.curves[at->second];
        const WithError friction = group.mu_e();
        curve.x.push_back(shown_value(sweep, axes[over], group.values[over]));
        curve.y.push_back(friction.value);
        curve.y_error.push_back(std::isfinite(friction.error) ? friction.error : 0);
    }
    return figure;
}

constexpr std::size_t most_rows = 300;

DocumentTable group_table(const WalkSweep& sweep, const std::vector<std::size_t>& axes,
                          const std::vector<WalkGroup>& groups) {
    DocumentTable table{.id = "groups",
                        .title = "Effective friction",
                        .note = "Of the runs that do not tilt; none if at least half do.",
                        .columns = {},
                        .rows = {}};
    for (const std::size_t axis : axes) table.columns.push_back({label_of(sweep, axis)});
    for (const char* heading : {"μ_e", "runs", "tilting"}) table.columns.push_back({heading});
    for (const WalkGroup& group : groups) {
        std::vector<Cell>& row = table.rows.emplace_back();
        for (std::size_t k = 0; k < axes.size(); ++k)
            row.push_back(std::holds_alternative<double>(group.values[k])
                              ? Cell(shown_value(sweep, axes[k], group.values[k]))
                              : group.values[k]);
        row.emplace_back(group.mu_e());
        row.emplace_back(static_cast<double>(group.points.size()));
        row.emplace_back(static_cast<double>(group.n_tilted()));
    }
    return table;
}

bool is_number(const std::vector<WalkGroup>& groups, std::size_t place) {
    for (const WalkGroup& group : groups)
        if (!std::holds_alternative<double>(group.values[place])) return false;
    return true;
}

}  // namespace

std::optional<WalkSection> curves_section(const WalkSweep& sweep,
                                          const std::vector<WalkGroup>& groups) {
    const std::vector<std::size_t> axes = machine_axes(sweep);
    WalkSection result{.section = {.id = "curves", .heading = "Effective friction"}};
    for (std::size_t over = 0; over < axes.size(); ++over) {
        if (!is_number(groups, over)) continue;
        const Figure figure = figure_over(sweep, axes, over, groups);
        if (figure.curves.size() <= most_curves && figure.curves.front().x.size() > 1)
            result.section.figures.push_back(figure);
    }
    if (result.section.figures.empty()) return {};
    if (groups.size() <= most_rows)
        result.section.tables.push_back(group_table(sweep, axes, groups));
    return result;
}

}  // namespace tricontact::comparisons::walking

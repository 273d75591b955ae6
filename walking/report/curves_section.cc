#include <fmt/format.h>

#include <cmath>
#include <map>

#include "report/format.h"
#include "walking/report/walk_document.h"
#include "walking/report/walk_sweep_document.h"

namespace tricontact::walking {

namespace {

constexpr std::size_t most_curves = 8;

/// "κ_8 = -0.47, μ = 0.75" of all axes but one; empty if there is but one.
std::string name_of(const WalkSweep& sweep, const std::vector<std::size_t>& axes,
                    const WalkGroup& group, std::size_t but) {
    std::string name;
    for (std::size_t k = 0; k < axes.size(); ++k) {
        if (k == but) continue;
        if (!name.empty()) name += ", ";
        const auto* word = std::get_if<std::string>(&group.values[k]);
        name += label_of(sweep, axes[k]) + " = " +
                (word ? *word : report::as_given(shown_value(sweep, axes[k], group.values[k])));
    }
    return name;
}

/// What is drawn over each axis.
struct CurveQuantity {
    const char* id;
    const char* title;
    const char* label;
    const char* caption;
    report::WithError (*of)(const WalkGroup& group);
};

constexpr CurveQuantity quantities[] = {
    {"friction", "Effective friction", "μ_e",
     "Bars: 95 %, from the scatter between the starts, else of the run itself. Machines that tilt "
     "are left out.",
     [](const WalkGroup& group) { return group.mu_e(); }},
    {"frequency", "Characteristic frequency", "cycles per √(m/k_x)",
     "Of the spring force at the end of the runs; figure 5.27 of Wetter (2016). Bars: 95 %, mean "
     "of the runs' own. A gap: not all of the runs vibrate.",
     [](const WalkGroup& group) {
         return report::WithError{
             group.mean([](const WalkOutcome& o) { return o.vibration.frequency; }),
             group.mean([](const WalkOutcome& o) { return o.vibration.frequency_error; })};
     }},
    {"instability", "Time of instability", "t_is/T",
     "Share of the end of the runs in which the running variance of the spring force exceeds 0.1; "
     "figures 4.22 and 4.25 of Wetter (2016). Steady sliding counts as 0.",
     [](const WalkGroup& group) {
         return report::WithError{
             group.mean([](const WalkOutcome& o) { return o.vibration.instability; }), 0};
     }},
    {"growth", "Growth of disturbances of steady sliding", "√(k_x/m)",
     "Real part of the leading eigenvalue: above 0 small disturbances grow, at 0 they neither grow "
     "nor decay. A gap: there is no steady sliding.",
     [](const WalkGroup& group) {
         const Eigenvalues fastest_first = sliding_stability(group.machine());
         if (fastest_first.empty()) return report::WithError{NAN, 0};
         return report::WithError{is_neutral(fastest_first) ? 0 : fastest_first.front().real(), 0};
     }},
};

report::Figure figure_over(const WalkSweep& sweep, const std::vector<std::size_t>& axes,
                           std::size_t over, const std::vector<WalkGroup>& groups,
                           const CurveQuantity& quantity) {
    report::Figure figure{
        .id = fmt::format("{}_{}", quantity.id, over + 1),
        .title = fmt::format("{} over {}", quantity.title, label_of(sweep, axes[over])),
        .caption = quantity.caption,
        .x = {label_of(sweep, axes[over]), sweep.axes[axes[over]].logarithmic},
        .y = {quantity.label}};
    std::map<std::string, std::size_t> known;
    for (const WalkGroup& group : groups) {
        const std::string name = name_of(sweep, axes, group, over);
        const auto [at, is_new] = known.emplace(name, figure.curves.size());
        if (is_new)
            figure.curves.push_back({.name = name.empty() ? quantity.label : name,
                                     .kind = report::Curve::Kind::line_and_points});
        report::Curve& curve = figure.curves[at->second];
        const auto [value, error] = quantity.of(group);
        curve.add(shown_value(sweep, axes[over], group.values[over]), value);
        curve.y_error.push_back(std::isfinite(error) ? error : 0);
    }
    return figure;
}

constexpr std::size_t most_curve_rows = 300;

report::DocumentTable group_table(const WalkSweep& sweep, const std::vector<std::size_t>& axes,
                                  const std::vector<WalkGroup>& groups) {
    report::DocumentTable table{.id = "groups",
                                .title = "Effective friction",
                                .note = "Of the runs that do not tilt; none if at least half do."};
    for (const std::size_t axis : axes) table.columns.push_back({label_of(sweep, axis)});
    for (const char* heading : {"μ_e", "runs", "tilting"}) table.columns.push_back({heading});
    for (const WalkGroup& group : groups) {
        std::vector<report::Cell>& row = table.rows.emplace_back();
        for (std::size_t k = 0; k < axes.size(); ++k)
            row.push_back(shown_cell(sweep, axes[k], group.values[k]));
        row.insert(row.end(), {group.mu_e(), static_cast<double>(group.points.size()),
                               static_cast<double>(group.n_tilted())});
    }
    return table;
}

}  // namespace

std::optional<WalkSection> curves_section(const WalkSweep& sweep,
                                          const std::vector<WalkGroup>& groups) {
    const std::vector<std::size_t> axes = machine_axes(sweep);
    WalkSection result{.section = {.id = "curves", .heading = "Friction, vibration, stability"}};
    for (std::size_t over = 0; over < axes.size(); ++over) {
        if (!std::ranges::all_of(groups, [&](const WalkGroup& group) {
                return std::holds_alternative<double>(group.values[over]);
            }))
            continue;
        for (const CurveQuantity& quantity : quantities) {
            const report::Figure figure = figure_over(sweep, axes, over, groups, quantity);
            if (figure.curves.size() > most_curves || figure.curves.front().x.size() < 2)
                break;  // the others have as many curves
            result.section.figures.push_back(figure);
        }
    }
    if (result.section.figures.empty()) return {};
    if (groups.size() <= most_curve_rows)
        result.section.tables.push_back(group_table(sweep, axes, groups));
    return result;
}

}  // namespace tricontact::walking

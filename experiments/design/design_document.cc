#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "contact/base/special_values.h"
#include "experiments/design/design_report.h"
#include "experiments/design/level_line.h"
#include "io/keys/units.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

using report::Curve;
using report::Figure;

/// Of a key in figures: its unit with the prefix that suits the range.
report::Unit unit_of(const DesignAxis& axis) {
    if (axis.key().dimension == io::Dimension::none) return {};
    return report::fitting_unit(axis.range().to, std::string(io::si_unit(axis.key().dimension)));
}

report::FigureAxis figure_axis(const DesignAxis& axis) {
    const report::Unit unit = unit_of(axis);
    std::string label(axis.key().path);
    if (!unit.symbol.empty()) label += " [" + unit.symbol + ']';
    return {.label = label,
            .logarithmic = axis.range().scale == io::Study::Scale::log,
            .low = axis.range().from / unit.factor,
            .high = axis.range().to / unit.factor};
}

double drawn(const DesignStudy& study, std::size_t axis, double fraction) {
    return study.value(axis, fraction) / unit_of(study.input.axes[axis]).factor;
}

std::string label_of(const DesignStudy& study, const Requirement& r) {
    return r.is_resolution() ? "resolution of " + study.input.quantity : r.name;
}

/// Of one key: each requirement over its limit.
Figure ratios_figure(const DesignStudy& study) {
    Figure figure{.id = "requirements",
                  .title = "Requirements over their limits",
                  .caption =
                      "Each finding over its limit (of what is at least its limit the "
                      "inverse). What lies below 1 is met.",
                  .x = figure_axis(study.input.axes[0]),
                  .y = {.label = "finding/limit", .logarithmic = true}};
    for (std::size_t i = 0; i < study.requirements.size(); ++i) {
        Curve curve{.name = label_of(study, study.requirements[i])};
        for (const DesignPoint& p : study.solution.grid)
            curve.add(drawn(study, 0, p.fractions[0]), p.ratios[i]);
        figure.curves.push_back(std::move(curve));
    }
    const auto& range = study.input.axes[0].range();
    const double factor = unit_of(study.input.axes[0]).factor;
    figure.curves.push_back({.name = "limit",
                             .x = {range.from / factor, range.to / factor},
                             .y = {1, 1},
                             .theory = true});
    const DesignPoint& best = study.solution.best;
    figure.curves.push_back({.name = "proposal",
                             .x = {drawn(study, 0, best.fractions[0])},
                             .y = {best.worst()},
                             .kind = Curve::Kind::points});
    return figure;
}

/// Lines along which one requirement is met exactly.
Curve limit_line(const DesignStudy& study, std::size_t requirement) {
    const DesignSolution& s = study.solution;
    LevelGrid grid;
    for (int i = 0; i < s.map_points; ++i)
        grid.places.push_back(static_cast<double>(i) / (s.map_points - 1));
    for (const DesignPoint& p : s.map) grid.values.push_back(std::log(p.ratios[requirement]));
    Curve curve{.name = label_of(study, study.requirements[requirement])};
    for (const auto& [a, b] : zero_line(grid)) {
        for (const auto& end : {a, b})
            curve.add(drawn(study, 0, end.first), drawn(study, 1, end.second));
        curve.add(contact::undefined, contact::undefined);
    }
    return curve;
}

Figure map_figure(const DesignStudy& study) {
    const DesignSolution& s = study.solution;
    report::ContourMap map{.label = "worst finding/limit",
                           .x = {},
                           .y = {},
                           .values = {},
                           .levels = {0.5, 0.7, 1, 1.5, 2, 3, 5, 10}};
    for (int i = 0; i < s.map_points; ++i) {
        const double fraction = static_cast<double>(i) / (s.map_points - 1);
        map.x.push_back(drawn(study, 0, fraction));
        map.y.push_back(drawn(study, 1, fraction));
    }
    for (const DesignPoint& p : s.map)
        map.values.push_back(std::isfinite(p.worst()) ? p.worst() : contact::undefined);
    std::string others;
    for (std::size_t axis = 2; axis < study.input.axes.size(); ++axis)
        others +=
            (others.empty() ? " At " : ", ") + value_text(study, axis, s.best.fractions[axis]);
    Figure figure{.id = "trade_off",
                  .title = "Where all requirements are met",
                  .caption =
                      "Largest finding over its limit; all are met up to the line of 1. "
                      "Curves: where each requirement alone is just met. White: not all "
                      "can be told." +
                      others + (others.empty() ? "" : "."),
                  .x = figure_axis(study.input.axes[0]),
                  .y = figure_axis(study.input.axes[1]),
                  .map = std::move(map)};
    for (std::size_t i = 0; i < study.requirements.size(); ++i)
        if (Curve line = limit_line(study, i); !line.x.empty())
            figure.curves.push_back(std::move(line));
    figure.curves.push_back({.name = s.best.is_feasible() ? "proposal" : "closest",
                             .x = {drawn(study, 0, s.best.fractions[0])},
                             .y = {drawn(study, 1, s.best.fractions[1])},
                             .kind = Curve::Kind::points});
    return figure;
}

/// Worst ratio of the assumptions, and the resolution in percent.
std::pair<double, double> trade_of(const DesignStudy& study, const DesignPoint& p) {
    DesignPoint assumptions{p.fractions, {}};
    double resolution = contact::undefined;
    for (std::size_t i = 0; i < study.requirements.size(); ++i)
        if (study.requirements[i].is_resolution())
            resolution = 100 * study.requirements[i].finding(p.ratios[i]);
        else
            assumptions.ratios.push_back(p.ratios[i]);
    return {assumptions.worst(), resolution};
}

Figure front_figure(const DesignStudy& study) {
    std::vector<std::pair<double, double>> all;
    for (const auto* points : {&study.solution.grid, &study.solution.map})
        for (const DesignPoint& p : *points)
            if (std::isfinite(p.worst())) all.push_back(trade_of(study, p));
    const auto best = trade_of(study, study.solution.best);
    all.push_back(best);
    Curve cloud{.name = "computed", .kind = Curve::Kind::points, .theory = true},
        front{.name = "none better in both", .kind = Curve::Kind::line_and_points};
    for (const auto& [x, y] : all) cloud.add(x, y);
    for (const auto& [x, y] : pareto_front(all)) front.add(x, y);
    return {.id = "front",
            .title = "Assumptions against resolution",
            .caption =
                fmt::format("Of all places computed, the worst finding of an assumption over its "
                            "limit and the resolution of the comparison: what is asked is at most "
                            "1 and at most {} %.",
                            report::as_given(100 * *study.input.resolution)),
            .x = {.label = "worst finding/limit of the assumptions", .logarithmic = true},
            .y = {.label = "resolution [%]", .logarithmic = true},
            .curves = {cloud,
                       front,
                       {.name = study.solution.best.is_feasible() ? "proposal" : "closest",
                        .x = {best.first},
                        .y = {best.second},
                        .kind = Curve::Kind::points}}};
}

report::DocumentTable requirements_table(const DesignStudy& study) {
    report::DocumentTable table{.id = "requirements_table",
                                .title = "Requirements at this place",
                                .columns = report::columns("requirement", "quantity", "finding",
                                                           "finding/limit:3", "assumption")};
    for (std::size_t i = 0; i < study.requirements.size(); ++i) {
        const Requirement& r = study.requirements[i];
        const double ratio = study.solution.best.ratios[i];
        table.rows.push_back({r.name, r.symbol, finding_text(r, ratio), ratio, r.claim});
    }
    return table;
}

}  // namespace

report::Document design_document(const DesignStudy& study) {
    report::Document document{
        .kind = "Design of a rig",
        .title = study.title,
        .lead =
            "Which values within their bounds make the chosen assumptions hold, and the "
            "comparison of measured and computed able to see what it shall: those with the "
            "largest of all least margins.",
        .files = {{"all numbers (JSON)", "design.json"}}};
    std::vector<report::Verdict> verdicts = design_verdicts(study);
    document.answer = std::move(verdicts.front());
    document.judged = "requirement", document.consequence = "margin";
    document.verdicts.assign(std::next(verdicts.begin()), verdicts.end());
    report::DocumentSection section{.id = "design", .heading = "The trade-off"};
    section.figures.push_back(study.input.axes.size() == 1 ? ratios_figure(study)
                                                           : map_figure(study));
    const bool has_both = study.input.resolution && study.requirements.size() > 1;
    if (has_both) section.figures.push_back(front_figure(study));
    section.tables.push_back(requirements_table(study));
    if (study.separation) section.tables.push_back(planned_table(study));
    document.sections.push_back(std::move(section));
    return document;
}

}  // namespace tricontact::experiments

#include <fmt/format.h>

#include <cmath>

#include "contact/base/special_values.h"
#include "report/format.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_document.h"

namespace tricontact::rolling {

namespace {

void add_model_columns(const RollingReport& report, report::DocumentTable& table) {
    for (const RollingRun& run : report.runs)
        table.columns.push_back({"over that of " + report::display_name(run.model)});
}

report::DocumentTable model_table(const RollingReport& report) {
    report::DocumentTable table{
        .id = "resistance",
        .title = "Rolling resistance",
        .note =
            "The pressure leans forward and resists, W per rolled way; the lead is its moment "
            "about the body's lowest point over F_N, undefined for springs, which have no "
            "pressure. The material dissipates what resistance and friction's traction work on it.",
        .columns = report::columns("model", "resistance W [N]", "W/F_N", "lead/a",
                                   "dissipation of the material [J/m]")};
    for (const RollingRun& run : report.runs) {
        const auto& s = run.history.steady;
        table.rows.push_back({report::display_name(run.model), s.resistance,
                              s.resistance / s.normal_force, s.pressure_lead / s.half_length,
                              s.material_dissipation});
    }
    return table;
}

report::DocumentTable resistance_theory_table(const RollingReport& report) {
    report::DocumentTable table{
        .id = "resistance_theories",
        .title = "Closed forms of the resistance",
        .note =
            "Without friction. Slow rolling is the first order in the speed, the same for "
            "every substrate that relaxes as one; the others are on the half-space. Sources: "
            "docs/explanation/rolling.md.",
        .columns = {{"theory"}, {"W/F_N"}}};
    add_model_columns(report, table);
    for (const ClosedForm& theory : resistance_theories(report.c)) {
        std::vector<report::Cell> row{theory.name, theory.value};
        for (const RollingRun& run : report.runs) {
            const auto& s = run.history.steady;
            row.emplace_back(s.resistance == 0 ? contact::undefined
                                               : theory.value * s.normal_force / s.resistance);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

constexpr int curve_points = 200;

report::Figure creep_figure(const RollingReport& report) {
    const contact::Friction& friction = report.c.friction;
    const double unit = creepage_unit(report.c);
    const bool across = !straight(report.c);
    report::Figure figure{
        .id = "creep",
        .title = "Creep curve",
        .caption =
            "Steady states at prescribed creepages ξ, each solved by itself; "
            "lateral drive and spin are those of the case.",
        .x = {fmt::format("creepage ξ over {} [-]", report::significant(unit, 4))},
        .y = {fmt::format("force over {} [-]", friction.is_coulomb() ? "μ F_N" : "F_lim")}};
    double farthest = 0;
    for (const RollingRun& run : report.runs) {
        const std::string name = report::display_name(run.model);
        report::Curve along{.name = name, .kind = report::Curve::Kind::line_and_points};
        report::Curve lateral{.name = name + ", F_y", .kind = report::Curve::Kind::line_and_points};
        for (const RollingState& s : run.creep_curve) {
            along.add(s.creepage.longitudinal / unit, force_ratio(s, friction));
            lateral.y.push_back(s.force[1] / friction_limit(s, friction));
        }
        if (along.x.empty()) continue;
        if (std::abs(along.x.back()) > std::abs(farthest)) farthest = along.x.back();
        lateral.x = along.x;
        figure.curves.push_back(std::move(along));
        if (across) figure.curves.push_back(std::move(lateral));
    }
    if (across) return figure;
    for (const CreepTheory& theory : creep_theories(report.c)) {
        const int colour = static_cast<int>(figure.curves.size());
        figure.curves
            .emplace_back(report::Curve{.name = theory.name, .theory = true, .colour = colour})
            .sample(0, farthest, curve_points,
                    [&](double creepage) { return theory.force_ratio(creepage * unit); });
    }
    return figure;
}

/// MDR's creepage over that of another model at the same force.
report::DocumentTable ratio_table(const RollingReport& report) {
    report::DocumentTable table{
        .id = "creep_ratio",
        .title = "MDR's creepage over that of three dimensions",
        .note =
            "ξ of MDR at the same force over ξ of the other model, between the points of the "
            "creep curves." +
            (has_thesis_creep_ratio(report.c)
                 ? fmt::format(" The closed forms on the half-space have 4(2 - nu)/(4 - 3 nu) = "
                               "{} for all forces (2.2.31).",
                               report::significant(thesis_creep_ratio(report.c), 4))
                 : ""),
        .columns = {{report.c.friction.is_coulomb() ? "F_x/(μ F_N)" : "F_x/F_lim", 2}}};
    const RollingRun* mdr = run_of_springs(report);
    if (!mdr || mdr->creep_curve.empty() || report.runs.size() < 2) return table;
    for (const RollingRun& run : report.runs)
        if (&run != mdr) table.columns.push_back({"over " + report::display_name(run.model)});
    const contact::Friction& friction = report.c.friction;
    const double sign = drive_sign(report.c);
    for (const double f : {.1, .2, .3, .4, .5, .6, .7, .8, .9}) {
        const auto bed = creepage_at(*mdr, friction, sign * f);
        std::vector<report::Cell> row{sign * f};
        for (const RollingRun& run : report.runs) {
            if (&run == mdr) continue;
            const auto other = creepage_at(run, friction, sign * f);
            if (bed && other) row.emplace_back(*bed / *other);
        }
        if (row.size() == table.columns.size()) table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

std::vector<std::pair<CreepTheory, std::optional<double>>> theory_values(
    const RollingReport& report) {
    std::vector<std::pair<CreepTheory, std::optional<double>>> values;
    if (!straight(report.c) || report.runs.empty()) return values;
    const RollingState& steady = report.runs.front().history.steady;
    const double f = force_ratio(steady, report.c.friction);
    for (CreepTheory& theory : creep_theories(report.c)) {
        std::optional<double> value;
        if (by_creepage(report.c))
            value = theory.force_ratio(steady.creepage.longitudinal);
        else if (std::abs(f) < 1)
            value = theory.creepage(f);
        values.emplace_back(std::move(theory), value);
    }
    return values;
}

report::DocumentTable theory_table(const RollingReport& report) {
    const contact::Friction& friction = report.c.friction;
    const bool forces = by_creepage(report.c);
    report::DocumentTable table{
        .id = "theories",
        .title = forces ? "Force at this creepage" : "Creepage under this force",
        .note =
            "On the half-space, whatever the case's layer. Sources: docs/explanation/rolling.md.",
        .columns = {{"theory"},
                    {!forces                 ? "ξ [unit]"
                     : friction.is_coulomb() ? "F_x/(μ F_N)"
                                             : "F_x/F_lim"}}};
    add_model_columns(report, table);
    for (const auto& [theory, value] : theory_values(report)) {
        if (!value) continue;
        std::vector<report::Cell> row{theory.name,
                                      forces ? *value : *value / creepage_unit(report.c)};
        for (const RollingRun& run : report.runs) {
            const auto& s = run.history.steady;
            row.emplace_back(*value /
                             (forces ? force_ratio(s, friction) : s.creepage.longitudinal));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

report::DocumentSection steady_section(const RollingReport& report) {
    return {.id = "steady_section",
            .heading = "Steady rolling",
            .tables = {steady_table(report), theory_table(report)}};
}

report::DocumentSection resistance_section(const RollingReport& report) {
    report::DocumentSection section{.id = "resistance_section",
                                    .heading = "Resistance of the relaxing substrate"};
    if (report.c.relaxation)
        section.tables = {model_table(report), resistance_theory_table(report)};
    return section;
}

report::DocumentSection creep_section(const RollingReport& report) {
    return {.id = "creep_section",
            .heading = "Force and creepage",
            .figures = {creep_figure(report)},
            .tables = {ratio_table(report)}};
}

}  // namespace tricontact::rolling

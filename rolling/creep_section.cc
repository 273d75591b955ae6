#include <fmt/format.h>

#include <cmath>

#include "report/format.h"
#include "rolling/creep_theory.h"
#include "rolling/readings.h"
#include "rolling/rolling_sections.h"

namespace tricontact::rolling {

namespace {

constexpr int curve_points = 200;

report::Figure creep_figure(const RollingReport& report) {
    const double mu = report.c.friction_coefficient, unit = creepage_unit(report.c);
    const bool across = !straight(report.c);
    report::Figure figure{
        .id = "creep",
        .title = "Creep curve",
        .caption =
            "Steady states at prescribed creepages ξ, each solved by itself; "
            "lateral drive and spin are those of the case.",
        .x = {fmt::format("creepage ξ over {} [-]", report::significant(unit, 4))},
        .y = {"force over μ F_N [-]"}};
    double farthest = 0;
    for (const RollingRun& run : report.runs) {
        const std::string name = report::display_name(run.model);
        report::Curve along{.name = name, .kind = report::Curve::Kind::line_and_points};
        report::Curve lateral{.name = name + ", F_y", .kind = report::Curve::Kind::line_and_points};
        for (const RollingState& s : run.creep_curve) {
            along.add(s.creepage.longitudinal / unit, force_ratio(s, mu));
            lateral.y.push_back(s.force[1] / (mu * s.normal_force));
        }
        if (along.x.empty()) continue;
        if (std::abs(along.x.back()) > std::abs(farthest)) farthest = along.x.back();
        lateral.x = along.x;
        figure.curves.push_back(std::move(along));
        if (across) figure.curves.push_back(std::move(lateral));
    }
    if (across) return figure;
    for (const CreepTheory& theory : creep_theories(report.c)) {
        report::Curve curve{
            .name = theory.name, .theory = true, .colour = static_cast<int>(figure.curves.size())};
        for (int i = 0; i <= curve_points; ++i) {
            const double creepage = farthest * i / curve_points;
            curve.add(creepage, theory.force_ratio(creepage * unit));
        }
        figure.curves.push_back(std::move(curve));
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
        .columns = {{"F_x/(μ F_N)", 2}}};
    const RollingRun* mdr = run_of(report, "mdr");
    if (!mdr || mdr->creep_curve.empty() || report.runs.size() < 2) return table;
    for (const RollingRun& run : report.runs)
        if (&run != mdr) table.columns.push_back({"over " + report::display_name(run.model)});
    const double mu = report.c.friction_coefficient, sign = drive_sign(report.c);
    for (const double f : {.1, .2, .3, .4, .5, .6, .7, .8, .9}) {
        const auto bed = creepage_at(*mdr, mu, sign * f);
        std::vector<report::Cell> row{sign * f};
        for (const RollingRun& run : report.runs) {
            if (&run == mdr) continue;
            const auto other = creepage_at(run, mu, sign * f);
            if (bed && other) row.emplace_back(*bed / *other);
        }
        if (row.size() == table.columns.size()) table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

report::DocumentSection creep_section(const RollingReport& report) {
    report::DocumentSection section{
        .id = "creep_section", .heading = "Force and creepage", .figures = {creep_figure(report)}};
    report::DocumentTable ratios = ratio_table(report);
    if (!ratios.rows.empty()) section.tables.push_back(std::move(ratios));
    return section;
}

}  // namespace tricontact::rolling

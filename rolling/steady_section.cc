#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "contact/special_values.h"
#include "report/format.h"
#include "rolling/creep_theory.h"
#include "rolling/readings.h"
#include "rolling/rolling_sections.h"

namespace tricontact::rolling {

namespace {

report::DocumentTable steady_table(const RollingReport& report) {
    const double mu = report.c.friction_coefficient, unit = creepage_unit(report.c);
    report::DocumentTable table{
        .id = "steady",
        .title = "Steady rolling",
        .note = fmt::format(
            "Forces are friction's on the substrate. Creepages ξ and η are in units of {}; a and b "
            "are half length and half width of the contact, along and across the rolling, by "
            "cells. Energy: what friction and a relaxing material dissipate less what creepage, "
            "spin and resistance work, over that work at the friction limit.",
            report::significant(unit, 4)),
        .columns = {{"model"},
                    {"ξ [unit]"},
                    {"η [unit]"},
                    {"F_x/(μ F_N)"},
                    {"F_y/(μ F_N)"},
                    {"M_z/(μ F_N a)"},
                    {"a [mm]"},
                    {"b [mm]"},
                    {"p_0 [MPa]"},
                    {"stick [share of area]", 3},
                    {"dissipation [J/m]"},
                    {"energy [-]", 2},
                    {"residual [-]", 2}}};
    for (const RollingRun& run : report.runs) {
        const auto& s = run.history.steady;
        const double limit = mu * s.normal_force;
        table.rows.push_back({report::display_name(run.model), s.creepage.longitudinal / unit,
                              s.creepage.lateral / unit, s.force[0] / limit, s.force[1] / limit,
                              s.spin_moment / limit / s.half_length, s.half_length * 1e3,
                              s.half_width * 1e3, s.peak_pressure * 1e-6,
                              s.stick_area / s.contact_area, s.dissipation,
                              energy_error(s, mu).value_or(contact::undefined), s.residual});
    }
    return table;
}

/// What closed forms say beside the first model.
report::DocumentTable theory_table(const RollingReport& report) {
    const double mu = report.c.friction_coefficient, unit = creepage_unit(report.c);
    const bool forces = by_creepage(report.c);
    report::DocumentTable table{
        .id = "theories",
        .title = forces ? "Force at this creepage" : "Creepage under this force",
        .note = "On the half-space, whatever the case's layer. Sources: docs/rolling.md.",
        .columns = {{"theory"}, {forces ? "F_x/(μ F_N)" : "ξ [unit]"}}};
    if (!straight(report.c)) return table;
    for (const RollingRun& run : report.runs)
        table.columns.push_back({"over that of " + report::display_name(run.model)});
    const auto& first = report.runs.front().history.steady;
    for (const CreepTheory& theory : creep_theories(report.c)) {
        const double f = force_ratio(first, mu), xi = first.creepage.longitudinal;
        if (!forces && !(std::abs(f) < 1)) continue;
        const double value = forces ? theory.force_ratio(xi) : theory.creepage(f);
        std::vector<report::Cell> row{theory.name, forces ? value : value / unit};
        for (const RollingRun& run : report.runs) {
            const auto& s = run.history.steady;
            row.emplace_back(value / (forces ? force_ratio(s, mu) : s.creepage.longitudinal));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

report::DocumentSection steady_section(const RollingReport& report) {
    report::DocumentSection section{
        .id = "steady_section", .heading = "Steady rolling", .tables = {steady_table(report)}};
    report::DocumentTable theories = theory_table(report);
    if (!theories.rows.empty()) section.tables.push_back(std::move(theories));
    return section;
}

}  // namespace tricontact::rolling

#include <limits>

#include "contact/special_values.h"
#include "report/format.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_sections.h"

namespace tricontact::rolling {

namespace {

report::DocumentTable model_table(const RollingReport& report) {
    report::DocumentTable table{
        .id = "resistance",
        .title = "Rolling resistance",
        .note =
            "The pressure leans forward and resists, W per rolled way; the lead is its moment "
            "about the body's lowest point over F_N, contact::undefined of springs, which have no "
            "pressure. The material dissipates what resistance and friction's traction work "
            "on it.",
        .columns = {{"model"},
                    {"resistance W [N]"},
                    {"W/F_N"},
                    {"lead/a"},
                    {"dissipation of the material [J/m]"}}};
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
            "docs/rolling.md.",
        .columns = {{"theory"}, {"W/F_N"}}};
    for (const RollingRun& run : report.runs)
        table.columns.push_back({"over that of " + report::display_name(run.model)});
    for (const ResistanceTheory& theory : resistance_theories(report.c)) {
        std::vector<report::Cell> row{theory.name, theory.ratio};
        for (const RollingRun& run : report.runs) {
            const auto& s = run.history.steady;
            row.emplace_back(s.resistance == 0 ? contact::undefined
                                               : theory.ratio * s.normal_force / s.resistance);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

report::DocumentSection resistance_section(const RollingReport& report) {
    report::DocumentSection section{.id = "resistance_section",
                                    .heading = "Resistance of the relaxing substrate"};
    if (!report.c.relaxation) return section;
    section.tables.push_back(model_table(report));
    report::DocumentTable theories = resistance_theory_table(report);
    if (!theories.rows.empty()) section.tables.push_back(std::move(theories));
    return section;
}

}  // namespace tricontact::rolling

#include <array>

#include "comparisons/quantities/quantities.h"
#include "report/csv.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_document.h"

namespace tricontact::rolling {

namespace {

struct Column {
    const char* name;
    double (*value)(const RollingState&);
};

const std::array<Column, 19> columns{{
    {"longitudinal_creepage", [](const RollingState& s) { return s.creepage.longitudinal; }},
    {"lateral_creepage", [](const RollingState& s) { return s.creepage.lateral; }},
    {"spin_per_m", [](const RollingState& s) { return s.creepage.spin; }},
    {"tangential_force_x_N", [](const RollingState& s) { return s.force[0]; }},
    {"tangential_force_y_N", [](const RollingState& s) { return s.force[1]; }},
    {"spin_moment_Nm", [](const RollingState& s) { return s.spin_moment; }},
    {comparisons::quantities::normal_force.key,
     [](const RollingState& s) { return s.normal_force; }},
    {comparisons::quantities::indentation.key, [](const RollingState& s) { return s.indentation; }},
    {"half_length_m", [](const RollingState& s) { return s.half_length; }},
    {"half_width_m", [](const RollingState& s) { return s.half_width; }},
    {comparisons::quantities::peak_pressure.key,
     [](const RollingState& s) { return s.peak_pressure; }},
    {"contact_area_m2", [](const RollingState& s) { return s.contact_area; }},
    {"stick_area_m2", [](const RollingState& s) { return s.stick_area; }},
    {"slip_area_m2", [](const RollingState& s) { return s.slip_area; }},
    {"dissipation_J_per_m", [](const RollingState& s) { return s.dissipation; }},
    {"material_dissipation_J_per_m", [](const RollingState& s) { return s.material_dissipation; }},
    {"resistance_N", [](const RollingState& s) { return s.resistance; }},
    {"pressure_lead_m", [](const RollingState& s) { return s.pressure_lead; }},
    {"residual", [](const RollingState& s) { return s.residual; }},
}};

std::string row(const std::string& first, const RollingState& state) {
    std::vector<std::string> fields{first};
    for (const Column& column : columns) fields.push_back(report::csv_field(column.value(state)));
    return report::csv_line(fields);
}

}  // namespace

std::string history_csv(const RollingRun& run) {
    std::vector<std::string> names{"distance_m"};
    for (const Column& column : columns) names.emplace_back(column.name);
    std::string text = report::csv_line(names);
    for (const RollingState& state : run.history.transient)
        text += row(report::csv_field(state.distance), state);
    return text + row("", run.history.steady);
}

std::string creep_csv(const RollingReport& report) {
    std::string text = report::csv_line({"model", "longitudinal_creepage", "force_ratio_x",
                                         "force_ratio_y", "stick_share", "dissipation_J_per_m"});
    const std::vector<RollingState>* first = nullptr;
    for (const RollingRun& run : report.runs) {
        if (!first && !run.creep_curve.empty()) first = &run.creep_curve;
        for (const RollingState& s : run.creep_curve) {
            const double limit = report.c.friction_coefficient * s.normal_force;
            text += report::csv_line({run.model, report::csv_field(s.creepage.longitudinal),
                                      report::csv_field(s.force[0] / limit),
                                      report::csv_field(s.force[1] / limit),
                                      report::csv_field(s.stick_area / s.contact_area),
                                      report::csv_field(s.dissipation)});
        }
    }
    if (!first) return text;
    for (const CreepTheory& theory : creep_theories(report.c))
        for (const RollingState& s : *first)
            text += report::csv_line(
                {theory.key, report::csv_field(s.creepage.longitudinal),
                 report::csv_field(theory.force_ratio(s.creepage.longitudinal)), "", "", ""});
    return text;
}

}  // namespace tricontact::rolling

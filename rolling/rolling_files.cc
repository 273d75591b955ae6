#include <array>

#include "comparisons/quantities/quantities.h"
#include "report/csv.h"
#include "report/json_number.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_document.h"
#include "rolling/rolling_report.h"

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

using Json = nlohmann::ordered_json;

Json steady_json(const RollingState& s, double friction_coefficient) {
    return {{"longitudinal_creepage", report::number(s.creepage.longitudinal)},
            {"lateral_creepage", report::number(s.creepage.lateral)},
            {"spin_per_m", report::number(s.creepage.spin)},
            {"tangential_force_N", report::numbers(s.force)},
            {"force_ratio", report::number(force_ratio(s, friction_coefficient))},
            {"spin_moment_Nm", report::number(s.spin_moment)},
            {comparisons::quantities::normal_force.key, report::number(s.normal_force)},
            {comparisons::quantities::indentation.key, report::number(s.indentation)},
            {"half_length_m", report::number(s.half_length)},
            {"half_width_m", report::number(s.half_width)},
            {comparisons::quantities::peak_pressure.key, report::number(s.peak_pressure)},
            {"contact_area_m2", report::number(s.contact_area)},
            {"stick_share", report::number(s.stick_area / s.contact_area)},
            {"dissipation_J_per_m", report::number(s.dissipation)},
            {"material_dissipation_J_per_m", report::number(s.material_dissipation)},
            {"resistance_N", report::number(s.resistance)},
            {"energy_error", report::number(energy_error(s, friction_coefficient))},
            {"pressure_lead_m", report::number(s.pressure_lead)},
            {"iterations", s.iterations},
            {"residual", report::number(s.residual)}};
}

Json run_json(const RollingReport& report, const RollingRun& run) {
    const double mu = report.c.friction_coefficient;
    Json json{{"model", run.model},
              {"steady", steady_json(run.history.steady, mu)},
              {"rolled_steps", run.history.transient.size() - 1},
              {"steady_after", report::number(steady_after(report, run))},
              {"creep_curve", Json::array()}};
    for (const RollingState& s : run.creep_curve)
        json["creep_curve"].push_back(
            {{"longitudinal_creepage", report::number(s.creepage.longitudinal)},
             {"force_ratio", report::number(force_ratio(s, mu))}});
    return json;
}

/// Creepage that each theory gives at the force of the case, or the force at its creepage.
Json theories_json(const RollingReport& report) {
    Json json = Json::array();
    if (!straight(report.c) || report.runs.empty()) return json;
    const RollingState& steady = report.runs.front().history.steady;
    const double f = force_ratio(steady, report.c.friction_coefficient);
    const double xi = steady.creepage.longitudinal;
    for (const CreepTheory& theory : creep_theories(report.c)) {
        Json one{{"theory", theory.key}};
        if (by_creepage(report.c))
            one["force_ratio"] = report::number(theory.force_ratio(xi));
        else
            one["longitudinal_creepage"] =
                std::abs(f) < 1 ? report::number(theory.creepage(f)) : Json();
        json.push_back(std::move(one));
    }
    return json;
}

Json free_creepages_json(const RollingReport& report) {
    Json json = Json::array();
    for (const FreeCreepage& one : free_creepages(report.c))
        json.push_back(
            {{"theory", one.key}, {"longitudinal_creepage", report::number(one.creepage)}});
    return json;
}

Json resistances_json(const RollingReport& report) {
    Json json = Json::array();
    for (const ResistanceTheory& one : resistance_theories(report.c))
        json.push_back({{"theory", one.key}, {"resistance_ratio", report::number(one.ratio)}});
    return json;
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

Json rolling_json(const RollingReport& report) {
    Json models = Json::array();
    for (const RollingRun& run : report.runs) models.push_back(run_json(report, run));
    return {{"creepage_unit", report::number(creepage_unit(report.c))},
            {"models", std::move(models)},
            {"theories", theories_json(report)},
            {"free_creepages", free_creepages_json(report)},
            {"resistances", resistances_json(report)},
            {"thesis_creep_ratio", report::number(thesis_creep_ratio(report.c))}};
}

}  // namespace tricontact::rolling

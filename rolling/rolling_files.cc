#include "comparisons/quantities/quantities.h"
#include "report/csv.h"
#include "report/json_number.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_document.h"

namespace tricontact::rolling {

namespace {

using Json = nlohmann::ordered_json;

/// What a state has in the files, in their order.
struct Column {
    enum class In { both, history, summary };

    const char* name;
    Json (*value)(const RollingState&, double friction_coefficient);
    In in = In::both;
};
using In = Column::In;

const Column columns[] = {
    {"longitudinal_creepage", [](auto& s, double) -> Json { return s.creepage.longitudinal; }},
    {"lateral_creepage", [](auto& s, double) -> Json { return s.creepage.lateral; }},
    {"spin_per_m", [](auto& s, double) -> Json { return s.creepage.spin; }},
    {"tangential_force_N", [](auto& s, double) { return report::numbers(s.force); }, In::summary},
    {"tangential_force_x_N", [](auto& s, double) -> Json { return s.force[0]; }, In::history},
    {"tangential_force_y_N", [](auto& s, double) -> Json { return s.force[1]; }, In::history},
    {"force_ratio", [](auto& s, double mu) -> Json { return force_ratio(s, mu); }, In::summary},
    {"spin_moment_Nm", [](auto& s, double) -> Json { return s.spin_moment; }},
    {comparisons::quantities::normal_force.key,
     [](auto& s, double) -> Json { return s.normal_force; }},
    {comparisons::quantities::indentation.key,
     [](auto& s, double) -> Json { return s.indentation; }},
    {"half_length_m", [](auto& s, double) -> Json { return s.half_length; }},
    {"half_width_m", [](auto& s, double) -> Json { return s.half_width; }},
    {comparisons::quantities::peak_pressure.key,
     [](auto& s, double) -> Json { return s.peak_pressure; }},
    {"contact_area_m2", [](auto& s, double) -> Json { return s.contact_area; }},
    {"stick_area_m2", [](auto& s, double) -> Json { return s.stick_area; }, In::history},
    {"slip_area_m2", [](auto& s, double) -> Json { return s.slip_area; }, In::history},
    {"stick_share", [](auto& s, double) -> Json { return s.stick_area / s.contact_area; },
     In::summary},
    {"dissipation_J_per_m", [](auto& s, double) -> Json { return s.dissipation; }},
    {"material_dissipation_J_per_m",
     [](auto& s, double) -> Json { return s.material_dissipation; }},
    {"resistance_N", [](auto& s, double) -> Json { return s.resistance; }},
    {"energy_error", [](auto& s, double) -> Json { return energy_error(s); }, In::summary},
    {"pressure_lead_m", [](auto& s, double) -> Json { return s.pressure_lead; }},
    {"iterations", [](auto& s, double) -> Json { return s.iterations; }, In::summary},
    {"residual", [](auto& s, double) -> Json { return s.residual; }}};

std::string row(const std::string& first, const RollingState& state) {
    std::vector<std::string> fields{first};
    for (const Column& column : columns)
        if (column.in != In::summary)
            fields.push_back(report::csv_field(column.value(state, 0).get<double>()));
    return report::csv_line(fields);
}

Json steady_json(const RollingState& state, double friction_coefficient) {
    Json json = Json::object();
    for (const Column& column : columns)
        if (column.in != In::history) json[column.name] = column.value(state, friction_coefficient);
    return json;
}

Json run_json(const RollingReport& report, const RollingRun& run) {
    const double mu = report.c.friction_coefficient();
    const auto point = [&](const RollingState& s) -> Json {
        return {{"longitudinal_creepage", s.creepage.longitudinal},
                {"force_ratio", force_ratio(s, mu)}};
    };
    return {{"model", run.model},
            {"steady", steady_json(run.history.steady, mu)},
            {"rolled_steps", run.history.transient.size() - 1},
            {"steady_after", steady_after(report, run)},
            {"creep_curve", report::list_of(run.creep_curve, point)}};
}

/// Creepage that each theory gives at the force of the case, or the force at its creepage.
Json theories_json(const RollingReport& report) {
    if (!straight(report.c) || report.runs.empty()) return Json::array();
    const RollingState& steady = report.runs.front().history.steady;
    const double f = force_ratio(steady, report.c.friction_coefficient());
    const double xi = steady.creepage.longitudinal;
    return report::list_of(creep_theories(report.c), [&](const CreepTheory& theory) -> Json {
        if (by_creepage(report.c))
            return {{"theory", theory.key}, {"force_ratio", theory.force_ratio(xi)}};
        return {{"theory", theory.key},
                {"longitudinal_creepage", std::abs(f) < 1 ? Json(theory.creepage(f)) : Json()}};
    });
}

Json closed_forms_json(const std::vector<ClosedForm>& forms, const char* quantity) {
    return report::list_of(forms, [&](const ClosedForm& form) -> Json {
        return {{"theory", form.key}, {quantity, form.value}};
    });
}

}  // namespace

std::string history_csv(const RollingRun& run) {
    std::vector<std::string> names{"distance_m"};
    for (const Column& column : columns)
        if (column.in != In::summary) names.emplace_back(column.name);
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
            const double limit = report.c.friction_coefficient() * s.normal_force;
            text +=
                report::csv_row(run.model, s.creepage.longitudinal, s.force[0] / limit,
                                s.force[1] / limit, s.stick_area / s.contact_area, s.dissipation);
        }
    }
    if (!first) return text;
    for (const CreepTheory& theory : creep_theories(report.c))
        for (const RollingState& s : *first)
            text += report::csv_row(theory.key, s.creepage.longitudinal,
                                    theory.force_ratio(s.creepage.longitudinal), "", "", "");
    return text;
}

Json rolling_json(const RollingReport& report) {
    const auto model = [&](const RollingRun& run) { return run_json(report, run); };
    return {
        {"creepage_unit", creepage_unit(report.c)},
        {"models", report::list_of(report.runs, model)},
        {"theories", theories_json(report)},
        {"free_creepages", closed_forms_json(free_creepages(report.c), "longitudinal_creepage")},
        {"resistances", closed_forms_json(resistance_theories(report.c), "resistance_ratio")},
        {"thesis_creep_ratio", thesis_creep_ratio(report.c)}};
}

}  // namespace tricontact::rolling

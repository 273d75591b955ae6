#include "comparisons/json_number.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/tractive/creep_theory.h"
#include "comparisons/tractive/readings.h"
#include "comparisons/tractive/rolling_document.h"

namespace tricontact::comparisons::tractive {

namespace {

using Json = nlohmann::ordered_json;
using tricontact::rolling::RollingState;

Json steady_json(const RollingState& s, double friction_coefficient) {
    return {{"longitudinal_creepage", number(s.creepage.longitudinal)},
            {"lateral_creepage", number(s.creepage.lateral)},
            {"spin_per_m", number(s.creepage.spin)},
            {"tangential_force_N", numbers(s.force)},
            {"force_ratio", number(force_ratio(s, friction_coefficient))},
            {"spin_moment_Nm", number(s.spin_moment)},
            {quantities::normal_force.key, number(s.normal_force)},
            {quantities::indentation.key, number(s.indentation)},
            {"half_length_m", number(s.half_length)},
            {"half_width_m", number(s.half_width)},
            {quantities::peak_pressure.key, number(s.peak_pressure)},
            {"contact_area_m2", number(s.contact_area)},
            {"stick_share", number(s.stick_area / s.contact_area)},
            {"dissipation_J_per_m", number(s.dissipation)},
            {"material_dissipation_J_per_m", number(s.material_dissipation)},
            {"resistance_N", number(s.resistance)},
            {"energy_error", number(energy_error(s, friction_coefficient))},
            {"pressure_lead_m", number(s.pressure_lead)},
            {"iterations", s.iterations},
            {"residual", number(s.residual)}};
}

Json run_json(const RollingReport& report, const RollingRun& run) {
    const double mu = report.c.friction_coefficient;
    Json json{{"model", run.model},
              {"steady", steady_json(run.history.steady, mu)},
              {"rolled_steps", run.history.transient.size() - 1},
              {"steady_after", number(steady_after(report, run))},
              {"creep_curve", Json::array()}};
    for (const RollingState& s : run.creep_curve)
        json["creep_curve"].push_back({{"longitudinal_creepage", number(s.creepage.longitudinal)},
                                       {"force_ratio", number(force_ratio(s, mu))}});
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
            one["force_ratio"] = number(theory.force_ratio(xi));
        else
            one["longitudinal_creepage"] = std::abs(f) < 1 ? number(theory.creepage(f)) : Json();
        json.push_back(std::move(one));
    }
    return json;
}

Json free_creepages_json(const RollingReport& report) {
    Json json = Json::array();
    for (const FreeCreepage& one : free_creepages(report.c))
        json.push_back({{"theory", one.key}, {"longitudinal_creepage", number(one.creepage)}});
    return json;
}

Json resistances_json(const RollingReport& report) {
    Json json = Json::array();
    for (const ResistanceTheory& one : resistance_theories(report.c))
        json.push_back({{"theory", one.key}, {"resistance_ratio", number(one.ratio)}});
    return json;
}

}  // namespace

Json rolling_json(const RollingReport& report) {
    Json models = Json::array();
    for (const RollingRun& run : report.runs) models.push_back(run_json(report, run));
    return {{"creepage_unit", number(creepage_unit(report.c))},
            {"models", std::move(models)},
            {"theories", theories_json(report)},
            {"free_creepages", free_creepages_json(report)},
            {"resistances", resistances_json(report)},
            {"thesis_creep_ratio", number(thesis_creep_ratio(report.c))}};
}

}  // namespace tricontact::comparisons::tractive

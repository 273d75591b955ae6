#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/quantities/quantities.h"
#include "report/csv.h"
#include "report/format.h"
#include "report/json_table.h"
#include "report/table_text.h"
#include "rolling/creep_theory.h"
#include "rolling/rolling_document.h"

namespace tricontact::rolling {

namespace {

using Json = nlohmann::ordered_json;

/// The highest in contact, and its part by friction; null where not asked for.
Json temperature_json(const RollingState& s, double HighestTemperature::*member) {
    return s.temperature ? Json((*s.temperature).*member) : Json();
}

/// What a state has in summary.json.
Json state_json(const RollingState& s, const contact::Friction& friction) {
    return {{"longitudinal_creepage", s.creepage.longitudinal},
            {"lateral_creepage", s.creepage.lateral},
            {"spin_per_m", s.creepage.spin},
            {"tangential_force_N", report::numbers(s.force)},
            {"force_ratio", force_ratio(s, friction)},
            {"spin_moment_Nm", s.spin_moment},
            {comparisons::quantities::normal_force.key, s.normal_force},
            {comparisons::quantities::indentation.key, s.indentation},
            {"half_length_m", s.half_length},
            {"half_width_m", s.half_width},
            {comparisons::quantities::peak_pressure.key, s.peak_pressure},
            {comparisons::quantities::contact_area.key, s.contact_area},
            {"stick_share", s.stick_area / s.contact_area},
            {"dissipation_J_per_m", s.dissipation},
            {"material_dissipation_J_per_m", s.material_dissipation},
            {"resistance_N", s.resistance},
            {"energy_error", energy_error(s)},
            {"pressure_lead_m", s.pressure_lead},
            {"highest_temperature_degC", temperature_json(s, &HighestTemperature::value)},
            {"friction_rise_K", temperature_json(s, &HighestTemperature::friction_rise)},
            {"iterations", s.iterations},
            {"residual", s.residual}};
}

/// The same in history.csv.
Json row_json(const RollingState& s) {
    Json row = state_json(s, {.coefficient = 1});
    row.update({{"distance_m", s.distance},
                {"tangential_force_x_N", s.force[0]},
                {"tangential_force_y_N", s.force[1]},
                {comparisons::quantities::stick_area.key, s.stick_area},
                {comparisons::quantities::slip_area.key, s.slip_area}});
    return row;
}

Json error_json(const std::optional<SteadyError>& error) {
    if (!error) return nullptr;
    return {{"half_widths", error->half_widths},
            {"exact", error->exact},
            {"why_none", error->why_none.empty() ? Json() : Json(error->why_none)}};
}

Json heat_json(const RollingReport& report, const RollingRun& run) {
    const auto numbers = heat_numbers(report, run);
    if (!numbers) return nullptr;
    return {{"peclet_indenter", numbers->peclet_indenter},
            {"peclet_substrate", numbers->peclet_substrate},
            {"substrate_share", numbers->substrate_share},
            {"band_error", numbers->band_error}};
}

Json run_json(const RollingReport& report, const RollingRun& run) {
    const contact::Friction& friction = report.c.friction;
    const auto point = [&](const RollingState& s) -> Json {
        return {{"longitudinal_creepage", s.creepage.longitudinal},
                {"force_ratio", force_ratio(s, friction)}};
    };
    return {
        {"model", run.model},
        {"steady", state_json(run.history.steady, friction)},
        {"from_fast_slip",
         run.history.from_fast_slip ? state_json(*run.history.from_fast_slip, friction) : Json()},
        {"heat", heat_json(report, run)},
        {"numerical_error", error_json(run.error)},
        {"response_variation", run.variation},
        {"rolled_steps", run.history.transient.size() - 1},
        {"steady_after", steady_after(report, run)},
        {"creep_curve", report::list_of(run.creep_curve, point)}};
}

Json theories_json(const RollingReport& report) {
    const char* quantity = by_creepage(report.c) ? "force_ratio" : "longitudinal_creepage";
    return report::list_of(theory_values(report), [&](const auto& one) -> Json {
        return {{"theory", one.first.key}, {quantity, one.second}};
    });
}

Json closed_forms_json(const std::vector<ClosedForm>& forms, const char* quantity) {
    return report::list_of(forms, [&](const ClosedForm& form) -> Json {
        return {{"theory", form.key}, {quantity, form.value}};
    });
}

}  // namespace

std::string history_csv(const RollingRun& run) {
    Json rows = report::list_of(run.history.transient, row_json);
    rows.push_back(row_json(run.history.steady));
    std::vector<std::string> columns{"distance_m",
                                     "longitudinal_creepage",
                                     "lateral_creepage",
                                     "spin_per_m",
                                     "tangential_force_x_N",
                                     "tangential_force_y_N",
                                     "spin_moment_Nm",
                                     comparisons::quantities::normal_force.key,
                                     comparisons::quantities::indentation.key,
                                     "half_length_m",
                                     "half_width_m",
                                     comparisons::quantities::peak_pressure.key,
                                     comparisons::quantities::contact_area.key,
                                     comparisons::quantities::stick_area.key,
                                     comparisons::quantities::slip_area.key,
                                     "dissipation_J_per_m",
                                     "material_dissipation_J_per_m",
                                     "resistance_N",
                                     "pressure_lead_m",
                                     "residual"};
    if (run.history.steady.temperature)
        columns.insert(columns.end(), {"highest_temperature_degC", "friction_rise_K"});
    return report::csv_of(rows, columns);
}

report::DocumentTable steady_table(const RollingReport& report) {
    const contact::Friction& friction = report.c.friction;
    const double unit = creepage_unit(report.c);
    const auto over_limit = [&](const char* force) {
        return fmt::format("{}/{}", force, friction.is_coulomb() ? "(μ F_N)" : "F_lim");
    };
    const auto row_of = [&](const RollingRun& run) {
        const RollingState& s = run.history.steady;
        Json row = state_json(s, friction);
        row["model"] = run.model;
        row["lateral_force_ratio"] = s.force[1] / friction_limit(s, friction);
        row["moment_ratio"] = s.spin_moment / friction_limit(s, friction) / s.half_length;
        return row;
    };
    return report::table_of(
        {.id = "steady",
         .title = "Steady rolling",
         .note = fmt::format(
             "Forces are friction's on the substrate. Creepages ξ and η are in units of {}; a and "
             "b are half length and half width of the contact, along and across the rolling, by "
             "cells. Energy: what friction and a relaxing material dissipate less what creepage, "
             "spin and resistance work, over that work at the friction limit.",
             report::significant(unit, 4))},
        report::list_of(report.runs, row_of),
        {{"model", "model"},
         {"longitudinal_creepage", "ξ [unit]", unit},
         {"lateral_creepage", "η [unit]", unit},
         {"force_ratio", over_limit("F_x")},
         {"lateral_force_ratio", over_limit("F_y")},
         {"stick_share", "stick [share of area]:3"},
         {"moment_ratio", friction.is_coulomb() ? "M_z/(μ F_N a)" : "M_z/(F_lim a)"},
         {"half_length_m", "a [mm]", 1e-3},
         {"half_width_m", "b [mm]", 1e-3},
         {comparisons::quantities::peak_pressure.key, "p_0 [MPa]", 1e6},
         {"dissipation_J_per_m", "dissipation [J/m]"},
         {"energy_error", "energy [-]:2"},
         {"residual", "residual [-]:2"}});
}

std::string steady_text(const RollingReport& report) {
    constexpr std::size_t up_to_stick = 6;
    const report::DocumentTable theories = theory_table(report);
    return fmt::format("creepages ξ and η in units of {}\n",
                       report::significant(creepage_unit(report.c), 4)) +
           report::table_text(steady_table(report), up_to_stick) +
           (theories.rows.empty() ? "" : report::table_text(theories));
}

std::string creep_csv(const RollingReport& report) {
    std::string text = report::csv_line({"model", "longitudinal_creepage", "force_ratio_x",
                                         "force_ratio_y", "stick_share", "dissipation_J_per_m"});
    const std::vector<RollingState>* first = nullptr;
    for (const RollingRun& run : report.runs) {
        if (!first && !run.creep_curve.empty()) first = &run.creep_curve;
        for (const RollingState& s : run.creep_curve) {
            const double limit = friction_limit(s, report.c.friction);
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

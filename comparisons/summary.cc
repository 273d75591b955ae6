#include "comparisons/summary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/json_number.h"
#include "comparisons/reference.h"
#include "comparisons/surface_fields.h"
#include "theory/body_rolling.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/oscillating_cylinder.h"
#include "theory/oscillating_rolling.h"

namespace tricontact::comparisons {

namespace {

using contact::History;
using contact::State;
using json = nlohmann::ordered_json;

std::optional<double> finite(double value) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<double> mapping_parameter(const contact::Case& c, const ModelSummary& s) {
    if (!contact::is_hertz_round(c)) return {};
    const double w = s.amplitude_ratio, u = s.final_shift_ratio;
    const bool defined = w * u > least_mapping_product && in_unit_range(w) && in_unit_range(u) &&
                         in_unit_range(s.tangential_ratio);
    if (s.state != State::shakedown || !defined) return {};
    return finite(theory::mapping_parameter(w, s.tangential_ratio, u));
}

/// w_lim of the half-space at f.
std::optional<double> amplitude_limit(const contact::Case& c, double f) {
    if (c.is_cylindrical()) return theory::line_amplitude_limit(f);
    return theory::has_body_theory(c) ? theory::amplitude_limit(c, f) : std::nullopt;
}

std::optional<double> ratcheting_slope(const contact::Case& c, const ModelSummary& s) {
    if (s.state != State::ratcheting || !in_unit_range(s.tangential_ratio)) return {};
    const auto limit = amplitude_limit(c, s.tangential_ratio);
    if (!limit) return {};
    const double excess = s.amplitude_ratio - *limit;
    return excess > 0 ? finite(*s.shift_increment_ratio / excess) : std::nullopt;
}

/// W0 [J] of the model's own scales.
double unit_dissipation(const contact::Case& c, const ModelSummary& s, const History& history) {
    if (c.is_cylindrical()) {
        const double bound = c.friction_coefficient * history.scales.normal_force;
        return theory::line_cycle_dissipation(s.tangential_ratio) * bound * bound * 2 /
               (std::numbers::pi * c.materials().effective_modulus() * c.indenter.length);
    }
    return theory::cycle_dissipation(
        {.friction_coefficient = c.friction_coefficient,
         .normal_force = history.scales.normal_force,
         .effective_shear_modulus = c.materials().effective_shear_modulus(),
         .contact_radius = s.contact_radius,
         .tangential_ratio = s.tangential_ratio});
}

void add_periods(const contact::Case& c, const History& history, ModelSummary& s) {
    s.periods = static_cast<int>(history.shift_per_period.size());
    for (const double shift : history.shift_per_period)
        s.shift_ratio_per_period.push_back(shift / s.unit_shift);
    if (s.periods > 0) {
        const double before =
            s.periods > 1 ? s.shift_ratio_per_period[s.periods - 2] : s.static_shift_ratio;
        s.shift_increment_ratio = s.shift_ratio_per_period.back() - before;
        s.state = history.verdict.state;
    }
    const bool closed = c.is_cylindrical() || contact::is_hertz_round(c);
    const bool known = closed && in_unit_range(s.tangential_ratio);
    const double unit = known ? unit_dissipation(c, s, history) : 0;
    for (const double work : history.dissipation_per_period)
        s.dissipation_ratio_per_period.push_back(finite(work / unit));
}

/// The largest von Mises stress in the last inside that was written; null without one.
json subsurface_json(const ModelSummary& s) {
    if (!s.subsurface) return {};
    const auto& [x, y, z] = s.subsurface->peak_position;
    return {{"phase", number(s.subsurface->phase)},
            {"peak_von_mises_Pa", number(s.subsurface->peak_von_mises)},
            {"peak_von_mises_ratio", number(s.subsurface->peak_von_mises / s.peak_pressure)},
            {"peak_position_m", {number(x), number(y), number(z)}}};
}

/// Null unless the indenter is a roller.
json ends_json(const ModelSummary& s) {
    if (!s.ends) return {};
    return {{"middle_half_width_m", number(s.ends->middle_half_width)},
            {"widest_half_width_ratio", number(s.ends->widest_ratio)},
            {"knuckle_m", number(s.ends->knuckle)},
            {"reach_m", number(s.ends->reach)}};
}

json to_json(const ModelSummary& s) {
    json audit = json::object();
    for (const auto& check : s.audit)
        audit[check.name] = {{"worst", number(check.worst)},
                             {"allowed", number(check.allowed)},
                             {"passed", check.passed()}};
    return {{"contact_radius_m", number(s.contact_radius)},
            {"indentation_m", number(s.indentation)},
            {"peak_pressure_Pa", number(s.peak_pressure)},
            {"unit_shift_m", number(s.unit_shift)},
            {"static_shift_ratio", number(s.static_shift_ratio)},
            {"shift_ratio_per_period", numbers(s.shift_ratio_per_period)},
            {"final_shift_ratio", number(s.final_shift_ratio)},
            {"shift_increment_ratio", number(s.shift_increment_ratio)},
            {"static_shift_m", number(s.static_shift)},
            {"final_shift_m", number(s.final_shift)},
            {"state", s.state ? json(contact::name_of(*s.state)) : json()},
            {"periods", s.periods},
            {"limit_tangential_ratio", number(s.limit_tangential_ratio)},
            {"stick_ratio", number(s.stick_ratio)},
            {"kappa", number(s.kappa)},
            {"eta", number(s.eta)},
            {"dissipation_ratio_per_period", numbers(s.dissipation_ratio_per_period)},
            {"ends", ends_json(s)},
            {"subsurface", subsurface_json(s)},
            {"steps", s.steps},
            {"cpu_s", number(s.cpu_s)},
            {"wall_s", number(s.wall_s)},
            {"max_force_residual_ratio", number(s.max_force_residual_ratio)},
            {"audit", audit}};
}

}  // namespace

ModelSummary summarise(const contact::Case& c, const History& history) {
    ModelSummary s;
    s.model = history.model;
    s.contact_radius = history.scales.contact_radius;
    s.indentation = history.scales.indentation;
    s.peak_pressure = history.scales.peak_pressure;
    s.unit_shift = history.scales.unit_shift;
    s.tangential_ratio = tangential_ratio(history);
    s.amplitude_ratio = amplitude_ratio(history);
    s.static_shift = history.static_shift;
    s.static_shift_ratio = s.static_shift / s.unit_shift;
    s.final_shift =
        history.shift_per_period.empty() ? s.static_shift : history.shift_per_period.back();
    s.final_shift_ratio = s.final_shift / s.unit_shift;
    add_periods(c, history, s);
    s.limit_tangential_ratio = history.limit_tangential_ratio;
    if (c.is_line_contact() && s.state == State::shakedown)
        if (const auto stick = stick_half_width(history, c.friction_coefficient))
            s.stick_ratio = *stick / s.contact_radius;
    if (constant_loads(c)) {
        s.kappa = mapping_parameter(c, s);
        s.eta = ratcheting_slope(c, s);
    }
    s.ends = roller_ends(c, history);
    s.subsurface = history.subsurface;
    s.steps = static_cast<int>(history.steps.size());
    s.cpu_s = history.cpu_s;
    s.wall_s = history.wall_s;
    for (const auto& step : history.steps)
        s.max_force_residual_ratio = std::max(s.max_force_residual_ratio, step.force_residual);
    s.audit = history.audit.checks();
    return s;
}

std::string summary_json(const std::string& version, const json& resolved_case,
                         const std::vector<ModelSummary>& summaries, const json& sections) {
    json models = json::object();
    for (const ModelSummary& summary : summaries) models[summary.model] = to_json(summary);
    json document{{"version", version}, {"case", resolved_case}, {"models", models}};
    for (const auto& [name, section] : sections.items())
        if (!section.empty()) document[name] = section;
    return document.dump(2) + "\n";
}

}  // namespace tricontact::comparisons

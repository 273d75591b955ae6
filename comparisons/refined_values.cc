#include "comparisons/refined_values.h"

#include <algorithm>
#include <cmath>

#include "comparisons/summary.h"

namespace tricontact::comparisons {

namespace {

/// A change of this many solver tolerances says nothing: shifts gather the errors of many steps.
constexpr double noisy_tolerances = 10;

struct Description {
    const char *name, *label, *symbol, *base;
};
constexpr Description descriptions[] = {
    {"normal_force_N", "normal force <i>F</i><sub>N</sub>", "F_N", "N"},
    {"indentation_m", "indentation <i>d</i>", "d", "m"},
    {"contact_radius_m", "contact radius <i>a</i>", "a", "m"},
    {"peak_pressure_Pa", "peak pressure <i>p</i><sub>0</sub>", "p_0", "Pa"},
    {"unit_shift_m", "unit of shift <i>U</i><sub>max</sub>", "U_max", "m"},
    {"static_shift_m", "static shift <i>U</i><sub>stat</sub>", "U_stat", "m"},
    {"static_shift_ratio", "static shift <i>u</i><sub>stat</sub>", "u_stat", ""},
    {"final_shift_m", "final shift <i>U</i><sub>end</sub>", "U_end", "m"},
    {"final_shift_ratio", "final shift <i>u</i><sub>end</sub>", "u_end", ""},
    {"shift_increment_ratio", "last period's Δ<i>u</i>", "Δu", ""}};

std::optional<double> value_of(const LevelValues& values, const std::string& name) {
    const auto found = values.find(name);
    return found == values.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> exact_value(const PressedValues& exact, const std::string& name) {
    for (const PressedQuantity& q : pressed_quantities())
        if (name == q.key) return q.get(exact);
    return {};
}

}  // namespace

LevelValues level_values(const contact::Case& c, const contact::History& history) {
    const ModelSummary s = summarise(c, history);
    LevelValues values{{"normal_force_N", history.scales.normal_force},
                       {"indentation_m", s.indentation},
                       {"contact_radius_m", s.contact_radius},
                       {"peak_pressure_Pa", s.peak_pressure},
                       {"unit_shift_m", s.unit_shift},
                       {"static_shift_m", s.static_shift},
                       {"static_shift_ratio", s.static_shift_ratio}};
    if (s.periods == 0) return values;
    values["final_shift_m"] = s.final_shift;
    values["final_shift_ratio"] = s.final_shift_ratio;
    // After shakedown the increment is what is left of nothing.
    if (s.state == contact::State::ratcheting)
        values["shift_increment_ratio"] = *s.shift_increment_ratio;
    return values;
}

Refinement make_refinement(const RefinedLevels& levels) {
    Refinement result{.model = levels.model,
                      .key = levels.key,
                      .sizes = levels.sizes,
                      .cpu_s = levels.cpu_s,
                      .quantities = {},
                      .exact_name = levels.exact_name,
                      .wide_factor = levels.wide ? levels.wide_factor : 0};
    for (const Description& d : descriptions) {
        RefinedQuantity q{d.name, d.label, d.symbol, d.base, {}, {}, {}, {}};
        for (const LevelValues& values : levels.values)
            if (const auto value = value_of(values, d.name)) q.values.push_back(*value);
        if (q.values.size() != levels.sizes.size()) continue;
        q.limit = estimate_limit(levels.sizes, q.values,
                                 noisy_tolerances * levels.tolerance * std::abs(q.values.back()));
        if (levels.exact) q.exact = exact_value(*levels.exact, d.name);
        if (levels.wide) q.wide = value_of(*levels.wide, d.name);
        result.quantities.push_back(std::move(q));
    }
    return result;
}

}  // namespace tricontact::comparisons

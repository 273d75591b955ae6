#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/roller_ends.h"
#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// kappa carries the error of f_T divided by w u; below this product only noise is left of it.
inline constexpr double least_mapping_product = 1e-5;

/// The numbers of one model's history. SI units; "ratio" of a shift: over the model's own U_max.
/// Empty where a quantity is undefined.
struct ModelSummary {
    std::string model;
    double contact_radius = 0;    ///< a [m]
    double indentation = 0;       ///< d [m]
    double peak_pressure = 0;     ///< p0 [Pa]
    double unit_shift = 0;        ///< U_max [m]
    double tangential_ratio = 0;  ///< f_T = F_T/(mu F_N) after loading
    double amplitude_ratio = 0;   ///< w = W/a
    double static_shift = 0;      ///< after loading, before rolling [m]
    double final_shift = 0;       ///< upright after the last period [m]
    double static_shift_ratio = 0, final_shift_ratio = 0;
    std::vector<double> shift_ratio_per_period;   ///< indenter upright, n = 1, 2, ...
    std::optional<double> shift_increment_ratio;  ///< of the last period; empty without rolling
    std::optional<contact::State> state;          ///< empty without rolling
    int periods = 0;
    double limit_tangential_ratio = 0;  ///< f_T,lim from the computed pressures

    /// c_sd/a, half width of what always sticks; empty unless a line contact shook down.
    std::optional<double> stick_ratio;
    /// Mapping parameter of f_T = 1 - kappa w u - (1-u)^(3/2) (3.2.16), u the final shift ratio.
    /// Empty unless a paraboloid's or sphere's model shook down under constant loads, 0 <= w, u <=
    /// 1 and w u > 1e-5 (an error of f_T counts 1/(w u) times).
    std::optional<double> kappa;
    /// Ratcheting slope eta = Du/(w - w_lim), Du the shift increment ratio of the last period and
    /// w_lim the half-space's limit at f_T (theory::amplitude_limit), of a line contact (3.5.27).
    /// Empty unless ratcheting under constant loads, w > w_lim.
    std::optional<double> eta;

    /// Frictional work per period over W0, the work of one cycle of oscillating F_T (Mindlin and
    /// Deresiewicz 1953; of a line contact line_cycle_dissipation()) with the model's own F_N, a
    /// and f_T. Elements empty when f_T = 0 and for bodies that are no paraboloid, sphere or
    /// cylinder.
    std::vector<std::optional<double>> dissipation_ratio_per_period;

    std::optional<RollerEnds> ends;                 ///< empty unless the indenter is a roller
    std::optional<contact::Subsurface> subsurface;  ///< empty where no inside was written
    int steps = 0;
    double cpu_s = 0, wall_s = 0;
    double max_force_residual_ratio = 0;  ///< worst force balance over F_N or mu F_N
    std::vector<contact::Audit::Check> audit;
};

ModelSummary summarise(const contact::Case& c, const contact::History& history);

/// The text of summary.json: fixed keys in fixed order, undefined and non-finite numbers as null.
/// `resolved_case` becomes the value of "case"; `sections` is an object whose members stand behind
/// the models, unless they are empty: "layer" (see layer.h), "loading_variants" (loading_study.h),
/// "relaxation" (relaxation_report.h).
std::string summary_json(const std::string& version, const nlohmann::ordered_json& resolved_case,
                         const std::vector<ModelSummary>& summaries,
                         const nlohmann::ordered_json& sections = nlohmann::ordered_json::object());

}  // namespace tricontact::comparisons

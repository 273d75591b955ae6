#include <cmath>
#include <numbers>

#include "comparisons/quantities/quantities.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::comparisons::quantities {

namespace {

using contact::Case;
using contact::History;

/// f_T of the oscillating force that W0 is about: along a path half of what the force covers in its
/// last closed cycle, under one normal force; else NaN.
double oscillating_ratio(const Subject& s) {
    if (!s.c.prescribed_path) return comparisons::tangential_ratio(s.history);
    return !s.loops.empty() && s.loops.back().has_constant_force
               ? s.loops.back().force_amplitude / s.history.friction_limit
               : NAN;
}

/// W0 [J] of the model's own scales; empty where there is no closed form of it.
std::optional<double> unit_dissipation(const Subject& s) {
    const auto& [c, history, loops] = s;
    const double f = oscillating_ratio(s);
    if (!in_unit_range(f) || !c.friction.is_coulomb() || c.interface.is_elastic() ||
        c.has_bulk_stress() || c.adhesion)
        return {};
    if (c.is_cylindrical()) {
        const double bound = c.friction_coefficient() * history.scales.normal_force;
        return theory::line_cycle_dissipation(f) * bound * bound * 2 /
               (std::numbers::pi * c.materials().effective_modulus() * c.indenter.length);
    }
    if (!contact::is_hertz_round(c)) return {};
    return theory::cycle_dissipation(
        {.friction_coefficient = c.friction_coefficient(),
         .normal_force = history.scales.normal_force,
         .effective_shear_modulus = c.materials().effective_shear_modulus(),
         .contact_radius = history.scales.contact_radius,
         .tangential_ratio = f});
}

Numbers work_ratios(const Subject& s) {
    Numbers list;
    const double unit = unit_dissipation(s).value_or(NAN);
    for (const double work : s.history.dissipation_per_period)
        list.push_back(number_of(finite(work / unit)));
    return list;
}

QuantityValue last_of(const auto& per_period) {
    return per_period.empty() ? QuantityValue() : finite(per_period.back());
}

constexpr const char* where_known =
    "under Coulomb's law with rolling, where f_T > 0, or closed cycles of a path under one normal "
    "force; the body is a paraboloid, sphere or cylinder";
constexpr const char* of_w0 = "Mindlin and Deresiewicz (1953)";

}  // namespace

constinit const Quantity dissipation{
    .key = "dissipation_J",
    .symbol = "D",
    .unit = "J",
    .name = "frictional work per period",
    .meaning = "Work of friction in the last period, of a path in its last closed cycle.",
    .defined = "with rolling, or along a path with a closed cycle",
    .of = [](const Subject& s) { return last_of(s.history.dissipation_per_period); },
    .is_refined = true,
    .is_plotted = true};

constinit const Quantity dissipation_ratio{
    .key = "dissipation_ratio",
    .symbol = "D/W_0",
    .over = "W_0",
    .name = "frictional work, last period",
    .meaning =
        "Work of friction in the last period over W_0, that of one cycle of oscillating F_T "
        "with the model's own F_N, a and f_T.",
    .defined = where_known,
    .source = of_w0,
    .of = [](const Subject& s) { return last_of(work_ratios(s)); },
    .part = Part::cost};

constinit const Quantity dissipation_ratio_per_period{
    .key = "dissipation_ratio_per_period",
    .symbol = "D_n/W_0",
    .over = "W_0",
    .name = "frictional work of each period",
    .meaning = "Work of friction in periods n = 1, 2, ... over W_0.",
    .defined = where_known,
    .source = of_w0,
    .of = [](const Subject& s) -> QuantityValue { return work_ratios(s); },
    .is_column = false};

constinit const Quantity slip_path{
    .key = "largest_slip_path_m",
    .symbol = "s_max",
    .unit = "m",
    .name = "largest slip path of a point",
    .meaning =
        "Way that the point of the surface which slips most slips back and forth in the last "
        "period, of a path in its last closed cycle: what fretting maps are drawn over.",
    .defined =
        "with rolling, or along a path with a closed cycle; not of `mdr` and `mdr-layer`, whose "
        "springs are no points of the surface",
    .source = "Vingsbo and Söderberg (1988)",
    .of = [](const Subject& s) { return last_of(s.history.slip_path_per_period); },
    .part = Part::cost,
    .is_plotted = true};

constinit const Quantity friction_work{
    .key = "largest_friction_work_J_per_m2",
    .symbol = "e_max",
    .unit = "J/m2",
    .name = "largest frictional work per area",
    .meaning =
        "Work of friction per area in the last period or closed cycle, at the point of the surface "
        "where it is "
        "largest: the energy density that wear is compared by.",
    .defined =
        "with rolling, or along a path with a closed cycle; not of `mdr` and `mdr-layer`, whose "
        "springs have no area",
    .source = "Fouvry, Kapsa and Vincent (1996)",
    .of = [](const Subject& s) { return last_of(s.history.friction_work_per_period); },
    .part = Part::cost,
    .is_plotted = true};

constinit const Quantity path_work{
    .key = "path_friction_work_J",
    .symbol = "D_path",
    .unit = "J",
    .name = "frictional work of the path",
    .meaning = "Work of friction from the first row of the prescribed path to its end.",
    .defined = "with a prescribed path",
    .of = [](const Subject& s) -> QuantityValue {
        if (!s.c.prescribed_path) return {};
        double work = 0;
        for (const contact::StepRecord& step : s.history.steps)
            if (step.phase > 0) work += step.dissipation;
        return finite(work);
    },
    .is_refined = true};

constinit const Quantity path_force{
    .key = "path_tangential_force_N",
    .symbol = "F_x,end",
    .unit = "N",
    .name = "tangential force at the end of the path",
    .meaning = "Force along x on the substrate in the last row of the prescribed path.",
    .defined = "with a prescribed path",
    .of = [](const Subject& s) -> QuantityValue {
        if (!s.c.prescribed_path) return {};
        return finite(s.history.steps.back().tangential_force[0]);
    },
    .is_refined = true};

List of_dissipation() {
    return {
        &dissipation, &path_work,    &path_force, &dissipation_ratio, &dissipation_ratio_per_period,
        &slip_path,   &friction_work};
}

}  // namespace tricontact::comparisons::quantities

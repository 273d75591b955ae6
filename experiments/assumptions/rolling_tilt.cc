// Whether the surface of the substrate is level with the plane in which the drive rolls.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

// The normal force has the component F_N tan(theta) along the surface.
constexpr const char* slope_source = "equilibrium on a slope";
constexpr Formula slope_beside_force("tilt_load", "|F_N tan(theta)/F_T|", "|F_N tan(theta)/F_T|",
                                     slope_source, "1", {&Rig::theta, &Rig::F_N, &Rig::F_T},
                                     [](const RigData& r) {
                                         return std::tan(r.theta) * r.F_N / r.F_T;
                                     });
constexpr Formula slope_beside_ratio("tilt_load", "|F_N tan(theta)/F_T|",
                                     "|tan(theta)/(f_T mu)|, f_T = F_T/(mu F_N)", slope_source, "1",
                                     {&Rig::theta, &Rig::f_T, &Rig::mu}, [](const RigData& r) {
                                         return std::tan(r.theta) / (r.f_T * r.mu);
                                     });
constexpr Formula slope_beside_friction("tilt_load", "|F_N tan(theta)/(mu F_N)|", "|tan(theta)/mu|",
                                        slope_source, "1", {&Rig::theta, &Rig::mu},
                                        [](const RigData& r) { return std::tan(r.theta) / r.mu; });

double layer_indentation(const RigData& r) {
    return r.L.is_known() ? layer_line_of(r).indentation : layer_of(r).indentation;
}
constexpr Formula height_change("height_change", "W_x tan(theta)/d",
                                "W_x tan(theta)/d, d of the layer", exact_layer, "1",
                                layer_inputs + Inputs{&Rig::theta, &Rig::W_x},
                                [](const RigData& r) {
                                    return r.W_x * std::tan(r.theta) / layer_indentation(r);
                                });

// Along a cylinder the slices of the layer are pressed by d + y tan(theta).
constexpr Inputs axis_inputs = layer_inputs + Inputs{&Rig::theta_axis};
constexpr Formula axis_indentation("axis_indentation", "|L tan(theta)/d|",
                                   "|L tan(theta)/d|, theta of the cylinder's axis, d of the layer",
                                   exact_layer, "1", axis_inputs, [](const RigData& r) {
                                       return r.L * std::tan(r.theta_axis) / layer_indentation(r);
                                   });
constexpr Formula end_load("end_load", "dF'/F'",
                           "k L tan(theta)/(2 F_N/L), k = d(F_N/L)/dd of the layer", exact_layer,
                           "1", axis_inputs, [](const RigData& r) {
                               const theory::LineContact line = layer_line_of(r);
                               return line.stiffness * r.L * std::tan(r.theta_axis) /
                                      (2 * line.load);
                           });

const Formula& load_formula(const Rig& rig) {
    const auto is_there = [](const RigNumber& one) { return one.is_known() && one != 0; };
    if (is_there(rig.F_T)) return slope_beside_force;
    return is_there(rig.f_T) ? slope_beside_ratio : slope_beside_friction;
}

Estimate magnitude(const Estimate& e) {
    return {std::abs(e.value), e.standard_error};
}

/// Adds the criterion that the magnitude is small. Its error is that of the signed number: of
/// 0 ± 0.2 degrees the magnitude has no derivative.
bool decide_magnitude(Assumption& a, const Rig& rig, const Formula& formula) {
    if (!decide(a, rig, formula, Criterion::Relation::at_most, accepted_difference,
                accepted_reason))
        return false;
    Calculation& c = a.criteria.back().calculation;
    c.result = magnitude(c.result);
    c.function = [signed_function = c.function](const Values& x) {
        return std::abs(signed_function(x));
    };
    return true;
}

/// "1.2 %", "up to 1.2 %" of what may be zero.
std::string share_text(const Estimate& e) {
    return e.value > e.standard_error ? percent_text(e.value, 2)
                                      : "up to " + percent_text(e.value + e.standard_error, 2);
}

/// Along the tangential force.
void add_slope(Assumption& a, const Rig& rig) {
    const Formula& load = load_formula(rig);
    if (!decide_magnitude(a, rig, load)) return;
    const std::string share = share_text(a.criteria.back().calculation.result);
    a.consequence = &load == &slope_beside_friction
                        ? fmt::format("The weight on the slope is {} of mu F_N.", share)
                        : fmt::format("The weight on the slope changes F_T by {}.", share);
    if (!rig.b.is_known() || !roller_is_rigid(rig) || rig.W_x <= 1e-9 * rig.W_y)
        return;  // rounding of 90 deg
    a.background.push_back(calculate(rig, height_change));
    a.consequence += fmt::format(
        " Rolling changes the height of the roller by {} of the indentation; the normal force, "
        "which is prescribed, stays.",
        share_text(magnitude(a.background.back().result)));
}

/// Along the axis of a cylinder.
void add_axis(Assumption& a, const Rig& rig) {
    if (!roller_is_rigid(rig)) {
        a.missing.emplace_back(theory_of_elastic_roller);
        return;
    }
    if (!decide_magnitude(a, rig, axis_indentation)) return;
    const Calculation& indentation = a.criteria.back().calculation;
    a.background.push_back(calculate(rig, end_load));
    if (!a.consequence.empty()) a.consequence += ' ';
    a.consequence +=
        indentation.result.value >= 2
            ? "One end of the cylinder is not pressed at all."
            : fmt::format(
                  "Along the cylinder the indentation changes by {}, the load per length "
                  "at its ends by {} to either side.",
                  share_text(indentation.result),
                  share_text(magnitude(a.background.back().result)));
}

// Line loads p' + q 2 y/L over the length of a half-space: the surface tilts by 2 q/L (2 ln(2 L/a)
// - 1)/(pi E*) to logarithmic accuracy in L/a, the displacement by a slender strip.
constexpr Formula end_load_on_half_space(
    "end_load", "dF'/F'", "pi E* L^2 theta/(2 F_N (2 ln(2 L/a) - 1))",
    "slender strip of pressure on a half-space, to logarithmic accuracy in L/a", "1",
    hertz_inputs + Inputs{&Rig::theta_axis}, [](const RigData& r) {
        return std::numbers::pi * materials_of(r).effective_modulus() * r.L * r.L *
               std::tan(r.theta_axis) /
               (2 * r.F_N * (2 * std::log(2 * r.L / line_half_width_of(r)) - 1));
    });

void add_axis_on_half_space(Assumption& a, const Rig& rig) {
    if (!decide_magnitude(a, rig, end_load_on_half_space)) return;
    const Estimate& load = a.criteria.back().calculation.result;
    if (!a.consequence.empty()) a.consequence += ' ';
    a.consequence += load.value >= 1
                         ? "One end of the cylinder is not pressed at all."
                         : fmt::format(
                               "The load per length at the ends changes by {} to either "
                               "side, the peak pressure by half of that.",
                               share_text(load));
}

}  // namespace

Assumption level_surface(const Rig& rig) {
    Assumption a{.name = "level_surface",
                 .title = "Level surface",
                 .claim = "The surface of the substrate is level with the plane of rolling"};
    add_slope(a, rig);
    if (rig.kind == Rig::Kind::cylinder) {
        if (rig.b.is_known())
            add_axis(a, rig);
        else
            add_axis_on_half_space(a, rig);
    }
    return a;
}

}  // namespace tricontact::experiments

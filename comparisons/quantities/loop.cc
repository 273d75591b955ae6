// The friction loop: force over shift in the last closed cycle of a path.
#include <functional>

#include "comparisons/quantities/friction_loop.h"
#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons::quantities {

namespace {

constexpr const char* where_closed =
    "along a path along x or y that ends with a closed cycle: from a reversal to the next but one, "
    "all that is prescribed being the same there";

template <auto value>
QuantityValue of_last_loop(const Subject& s) {
    const auto loops = friction_loops(s.c, s.history);
    if (loops.empty()) return {};
    return finite(std::invoke(value, loops.back()));
}

}  // namespace

constinit const Quantity loop_force{
    .key = "loop_force_amplitude_N",
    .symbol = "F_loop",
    .unit = "N",
    .name = "force of the loop",
    .meaning = "Half of what the tangential force covers in the last closed cycle of the path.",
    .defined = where_closed,
    .of = of_last_loop<&FrictionLoop::force_amplitude>,
    .part = Part::cost,
    .is_refined = true,
    .is_plotted = true};

constinit const Quantity loop_shift{
    .key = "loop_shift_amplitude_m",
    .symbol = "U_loop",
    .unit = "m",
    .name = "shift of the loop",
    .meaning = "Half of what the shift covers in the last closed cycle of the path.",
    .defined = where_closed,
    .of = of_last_loop<&FrictionLoop::shift_amplitude>,
    .part = Part::cost,
    .is_refined = true,
    .is_plotted = true};

constinit const Quantity loop_secant_stiffness{
    .key = "loop_secant_stiffness_N_per_m",
    .symbol = "k_sec",
    .unit = "N/m",
    .name = "secant stiffness of the loop",
    .meaning = "What the force covers over what the shift covers in the last closed cycle.",
    .defined = where_closed,
    .of = of_last_loop<&FrictionLoop::secant_stiffness>,
    .part = Part::cost,
    .is_refined = true};

constinit const Quantity loop_tangent_stiffness{
    .key = "loop_tangent_stiffness_N_per_m",
    .symbol = "k_tan",
    .unit = "N/m",
    .name = "tangent stiffness of the loop",
    .meaning =
        "Slope of force over shift at the reversals of the last closed cycle, mean of both: the "
        "contact that sticks all over.",
    .defined = "the same, with two steps or more between reversals",
    .source = "Mindlin (1949)",
    .of = of_last_loop<&FrictionLoop::tangent_stiffness>,
    .part = Part::cost,
    .is_refined = true};

constinit const Quantity loop_aperture{
    .key = "loop_aperture_m",
    .symbol = "U_0",
    .unit = "m",
    .name = "aperture of the loop",
    .meaning = "Width of the last closed cycle's loop midway between the forces at its reversals.",
    .defined = where_closed,
    .source = "Fouvry, Kapsa and Vincent (1996)",
    .of = of_last_loop<&FrictionLoop::aperture>,
    .part = Part::cost,
    .is_refined = true};

constinit const Quantity sliding_ratio{
    .key = "loop_sliding_ratio",
    .symbol = "U_0/(2 U_loop)",
    .name = "sliding ratio of the loop",
    .meaning = "Aperture over all that the shift covers in the last closed cycle, 0 to 1.",
    .defined = where_closed,
    .source = "Fouvry, Kapsa and Vincent (1996)",
    .of = of_last_loop<&FrictionLoop::sliding_ratio>,
    .part = Part::cost,
    .is_refined = true,
    .is_plotted = true};

constinit const Quantity slip_regime{
    .key = "slip_regime",
    .name = "regime of the loop",
    .meaning =
        "Of the last closed cycle: `stick` where friction does no work, `gross-slip` where the "
        "whole contact slips in a step, else `partial-slip`.",
    .defined = where_closed,
    .source = "Vingsbo and Söderberg (1988)",
    .of = [](const Subject& s) -> QuantityValue {
        const auto loops = friction_loops(s.c, s.history);
        if (loops.empty()) return {};
        return loops.back().regime;
    },
    .part = Part::cost};

List of_loop() {
    return {
        &slip_regime,   &loop_force,   &loop_shift, &loop_secant_stiffness, &loop_tangent_stiffness,
        &loop_aperture, &sliding_ratio};
}

}  // namespace tricontact::comparisons::quantities

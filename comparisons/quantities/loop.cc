// The friction loop: force over shift in the last closed cycle of a path.
#include <cmath>
#include <functional>
#include <numbers>

#include "comparisons/quantities/friction_loop.h"
#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons::quantities {

namespace {

constexpr const char* where_closed =
    "along a path along x or y that ends with a closed cycle: from a reversal to the next but one, "
    "all that is prescribed being the same there";

template <auto value>
QuantityValue of_last_loop(const Subject& s) {
    if (s.loops.empty()) return {};
    return finite(std::invoke(value, s.loops.back()));
}

constexpr const char* behind_rig =
    "the same, where `rig.tangential_stiffness` stands between drive and contact";

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
        if (s.loops.empty()) return {};
        return s.loops.back().regime;
    },
    .part = Part::cost};

constinit const Quantity path_regime{
    .key = "path_slip_regime",
    .name = "regime of the path",
    .meaning =
        "Regime that all closed cycles of the path have, as of `slip_regime`; `mixed` where they "
        "are not alike.",
    .defined = where_closed,
    .source = "Vingsbo and Söderberg (1988)",
    .of = [](const Subject& s) -> QuantityValue {
        const auto regime = common_regime(s.loops);
        return regime ? QuantityValue(*regime) : QuantityValue();
    },
    .part = Part::cost};

constinit const Quantity regime_changes_at{
    .key = "regime_changes_at_cycle",
    .name = "cycle at which the regime changes",
    .meaning = "Number of the first closed cycle whose regime is not that of the one before.",
    .defined = "the same, with cycles that are not alike",
    .of = [](const Subject& s) -> QuantityValue {
        const auto cycle = regime_change(s.loops);
        return cycle ? QuantityValue(*cycle) : QuantityValue();
    },
    .part = Part::cost,
    .is_counted = true};

constinit const Quantity loop_stick_radius{
    .key = "loop_stick_radius_m",
    .symbol = "c",
    .unit = "m",
    .name = "stick radius of the loop",
    .meaning =
        "Of what never slips in the last closed cycle, at its least in a step: radius of a disc of "
        "that area, of a line contact half its width; 0 in gross slip.",
    .defined = where_closed,
    .source = "Mindlin and Deresiewicz (1953)",
    .of = [](const Subject& s) -> QuantityValue {
        if (s.loops.empty()) return {};
        const double area = s.loops.back().least_stick_area;
        return s.c.is_line_contact() ? area / (2 * s.c.indenter.length)
                                     : std::sqrt(area / std::numbers::pi);
    },
    .part = Part::cost,
    .is_refined = true,
    .is_plotted = true};

constinit const Quantity gross_slip_shift{
    .key = "loop_gross_slip_shift_m",
    .symbol = "U_gs",
    .unit = "m",
    .name = "shift to gross slip",
    .meaning =
        "Shift from a reversal of the last closed cycle to where the whole contact slips, mean of "
        "both: 2 U_max of a Hertzian contact.",
    .defined = "the same, in gross slip, with two steps or more that stick after each reversal",
    .source = "Mindlin and Deresiewicz (1953)",
    .of = of_last_loop<&FrictionLoop::gross_slip_shift>,
    .part = Part::cost,
    .is_refined = true};

constinit const Quantity drive_shift{
    .key = "drive_shift_amplitude_m",
    .symbol = "U_drive",
    .unit = "m",
    .name = "shift of the drive",
    .meaning =
        "Half of what the drive's shift U + F_T/k covers in the last closed cycle. The work of "
        "that loop is that of the contact's.",
    .defined = behind_rig,
    .of = of_last_loop<&FrictionLoop::drive_shift_amplitude>,
    .part = Part::cost,
    .is_refined = true};

constinit const Quantity drive_secant_stiffness{
    .key = "drive_secant_stiffness_N_per_m",
    .symbol = "k_sec,drive",
    .unit = "N/m",
    .name = "secant stiffness of drive and contact",
    .meaning = "What the force covers over what the drive's shift covers: 1/(1/k_sec + 1/k).",
    .defined = behind_rig,
    .of = of_last_loop<&FrictionLoop::drive_secant_stiffness>,
    .part = Part::cost,
    .is_refined = true};

constinit const Quantity drive_sliding_ratio{
    .key = "drive_sliding_ratio",
    .symbol = "U_0/(2 U_drive)",
    .name = "sliding ratio of the drive's loop",
    .meaning = "Aperture over all that the drive's shift covers: what a machine's record shows.",
    .defined = behind_rig,
    .source = "Fouvry, Kapsa and Vincent (1996)",
    .of = of_last_loop<&FrictionLoop::drive_sliding_ratio>,
    .part = Part::cost,
    .is_refined = true};

List of_loop() {
    return {&slip_regime,
            &path_regime,
            &regime_changes_at,
            &loop_force,
            &loop_shift,
            &loop_secant_stiffness,
            &loop_tangent_stiffness,
            &loop_aperture,
            &sliding_ratio,
            &loop_stick_radius,
            &gross_slip_shift,
            &drive_shift,
            &drive_secant_stiffness,
            &drive_sliding_ratio};
}

}  // namespace tricontact::comparisons::quantities

// The normal contact of a cylinder: half-space or layer, and its ends.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/assumptions/rolling_parts.h"
#include "theory/sharp_edge.h"

namespace tricontact::experiments {

namespace {

using std::numbers::pi;

constexpr ComparedQuantity line_quantities[] = {
    {"contact_width", "2a", "2 sqrt(4 R F_N/(pi E* L))", "(3.5.2)", "m",
     [](const RigData& r) { return 2 * line_half_width_of(r); },
     [](const RigData& r) { return 2 * layer_line_of(r).half_width; }},
    {"peak_pressure", "p_0", "2 F_N/(pi a L)", "(3.5.2)", "Pa",
     [](const RigData& r) { return 2 * r.F_N / (pi * line_half_width_of(r) * r.L); },
     [](const RigData& r) { return layer_line_of(r).centre_pressure; }},
    {"indentation", "d", "2 F_N/(pi E* L) [(1 + ln 4)/2 + ln(L/a)]", "(3.5.3)", "m",
     [](const RigData& r) {
         return 2 * r.F_N / (pi * materials_of(r).effective_modulus() * r.L) *
                ((1 + std::log(4.)) / 2 + std::log(r.L / line_half_width_of(r)));
     },
     [](const RigData& r) { return layer_line_of(r).indentation; }}};

constexpr Formula line_thickness_ratio("thickness_ratio", "b/D_c", "b/(2 a)", "(5.1.13)", "1",
                                       {&Rig::b, &Rig::a},
                                       [](const RigData& r) { return r.b / (2 * r.a); });

constexpr Formula length_ratio("length_ratio", "L/a", "L/a", "section 5.1.5", "1",
                               {&Rig::L, &Rig::a}, [](const RigData& r) { return r.L / r.a; });

constexpr Formula end_pressure("end_pressure_ratio", "p_0'/p_0",
                               "1 - nu_2^2, ends of roller and substrate flush", "(5.1.14)", "1",
                               {&Rig::nu_2}, [](const RigData& r) { return 1 - r.nu_2 * r.nu_2; });

constexpr Formula edge_exponent(
    "edge_exponent", "lambda - 1",
    "p ~ y^(lambda - 1) at an edge of 90 degrees, lambda of Dundurs' alpha",
    "Dundurs and Lee (1972)", "1", materials, [](const RigData& r) {
        const double roller = r.E_1 / (1 - r.nu_1 * r.nu_1),
                     substrate = r.E_2 / (1 - r.nu_2 * r.nu_2);
        return theory::edge_pressure_exponent(pi / 2, (roller - substrate) / (roller + substrate));
    });

constexpr Formula moved_load("end_load_share", "dF/F_N",
                             "nu_2^2 2 (2 a)/L: a contact width at each end loses nu_2^2 p",
                             "(5.1.14)", "1", {&Rig::nu_2, &Rig::a, &Rig::L},
                             [](const RigData& r) { return r.nu_2 * r.nu_2 * 4 * r.a / r.L; });

std::string line_sentence(const Rig& rig) {
    const auto beside = [&](const ComparedQuantity& q) { return beside_hertz(q.ratio(rig)); };
    const auto& [width, pressure, indentation] = line_quantities;
    return fmt::format(
        "The contact width is {}, the peak pressure {}. The indentation is {}; a half-space has "
        "none of its own in plane strain, the formula of a block of length L on it gives {}.",
        beside(width), beside(pressure), quantity(indentation.layer(rig), "m", 3),
        quantity(indentation.half_space(rig), "m", 3));
}

// A contact width at each end needs two; a cylinder shorter than four of them is all ends.
constexpr double least_length_ratio = 8;
// The edge of a body a thousand times stiffer: the exponent is -1/2 within so much.
constexpr double rigid_edge = 2e-3;

/// What the ends of a cylinder do to its pressure.
std::string ends_sentences(const Rig& rig) {
    const auto value = [&](const Formula& formula) { return calculate(rig, formula).result.value; };
    std::string text = "Flush ends keep the pressure, as nu_2 = 0.";
    if (const double lost = 1 - value(end_pressure); lost > 0)
        text = fmt::format(
            "Flush ends lose {} of the pressure{}", percent_text(lost, 2),
            value(length_ratio) >= least_length_ratio
                ? fmt::format(
                      " over about a contact width each, which moves {} of the load inwards.",
                      percent_text(value(moved_load), 2))
                : "; the cylinder is too short for them to be apart.");
    if (const double exponent = value(edge_exponent); exponent < -rigid_edge)
        text += fmt::format(
            " A substrate that reaches past a sharp end has a pressure growing as y^{} there{}; "
            "rounded ends raise it within about their radius.",
            significant(exponent, 2),
            exponent < rigid_edge - 0.5 ? ", as under the edge of a rigid body" : "");
    if (is_thesis_rig(rig))
        text +=
            " The exponent -0.23 of section 5.1.5 belongs to two equal materials. The rig is "
            "between flush and reaching past; its ends are not measured.";
    return text;
}

}  // namespace

Assumption half_space_of_line(const Rig& rig) {
    return half_space_assumption(
        rig, calculate(rig, line_thickness_ratio), line_quantities,
        {"singular integral equation", "exact plane contact with a bonded layer", line_sentence});
}

Assumption long_cylinder(const Rig& rig) {
    return {.name = "long_cylinder",
            .title = "Long cylinder",
            .claim = "Pressure does not vary along the cylinder",
            .criteria = {{calculate(rig, moved_load), Criterion::Relation::at_most,
                          accepted_difference, accepted_reason}},
            .background = {calculate(rig, length_ratio), calculate(rig, end_pressure),
                           calculate(rig, edge_exponent)},
            .missing = {"how far the substrate reaches past the ends"},
            .consequence = ends_sentences(rig)};
}

}  // namespace tricontact::experiments

#include <fmt/format.h>

#include <cmath>

#include "comparisons/strength/body_strength.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;

std::string loads_text(const Strength& s) {
    std::string text =
        fmt::format("F_N = {}, F_T = {}", report::quantity(s.loads.normal_force, "N"),
                    report::quantity(s.loads.tangential_force, "N"));
    if (s.loads.bulk_stress != 0)
        text += fmt::format(", bulk stress {}", report::quantity(s.loads.bulk_stress, "Pa"));
    return text;
}

std::string first_yield_sentence(const Strength& s) {
    const BodyStrength& body = *s.weakest();
    std::string text = fmt::format(
        "Strength at {}: the {} {}. Its largest von Mises stress is {}, {} of the yield stress {}, "
        "{}.",
        loads_text(s), body.body, body.factor() < 1 ? "yields" : "stays elastic",
        report::quantity(body.peak.von_mises, "Pa"), report::significant(1 / body.factor(), 3),
        report::quantity(body.yield_stress, "Pa"),
        body.peak.depth == 0
            ? fmt::format("at the surface, x = {} a",
                          report::significant(body.peak.x / s.contact_radius, 2))
            : fmt::format("{} a below the surface",
                          report::significant(body.peak.depth / s.contact_radius, 2)));
    if (const auto force = s.first_yield_force())
        text += fmt::format(" It begins to yield at F_N = {}{}.", report::quantity(*force, "N"),
                            s.loads.tangential_force != 0 ? ", F_T in proportion" : "");
    return text;
}

/// Of passes over the same track.
std::string shakedown_sentence(const Case& c, const Strength& s) {
    if (!s.shakedown_pressure) return {};
    const double ratio = *s.pressure_over_k(), limit = *s.shakedown_pressure;
    const std::string numbers = fmt::format(
        "p_0/k = {}, limit of elastic shakedown {} at μ = {}{}", report::significant(ratio, 3),
        report::significant(limit, 3), report::significant(c.friction_coefficient(), 3),
        s.loads.bulk_stress != 0 ? ", without the bulk stress" : "");
    if (ratio > limit)
        return fmt::format(
            "A contact that slides over the same track again and again would deform this material "
            "plastically in every pass, alternating or ratcheting: {}.",
            numbers);
    return fmt::format("A contact that slides over the same track again and again {}: {}.",
                       s.weakest()->factor() < 1
                           ? "would be carried elastically after the first passes, by "
                             "residual stresses (shakedown)"
                           : "would stay below the limit of shakedown",
                       numbers);
}

std::string trailing_sentence(const Strength& s) {
    if (!s.line || (s.line->force_ratio == 0 && s.line->bulk_stress == 0)) return {};
    return fmt::format(
        "Stress along x at the trailing edge of the contact, where fretting cracks begin: {}, {} "
        "of the peak pressure.",
        report::quantity(s.line->trailing_stress(), "Pa"),
        report::significant(s.line->trailing_stress() / s.peak_pressure, 3));
}

}  // namespace

std::vector<std::string> strength_sentences(const Case& c, const Strength& s) {
    if (!s.is_known())
        return {fmt::format(
            "Strength is not judged: under {} the closed form would move the stick zone by {} a, "
            "so far that an edge of the contact slips backward.",
            loads_text(s), report::significant(s.stick_centre / s.contact_radius, 2))};
    std::vector<std::string> list;
    if (s.weakest()) list.push_back(first_yield_sentence(s));
    list.push_back(shakedown_sentence(c, s));
    list.push_back(trailing_sentence(s));
    std::erase(list, "");
    return list;
}

}  // namespace tricontact::comparisons

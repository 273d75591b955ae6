// The normal contact of a sphere: half-space or layer.
#include <fmt/format.h>

#include <cmath>

#include "experiments/assumptions/rolling_parts.h"
#include "theory/hertz.h"

namespace tricontact::experiments {

namespace {

constexpr const char* hertz_source = "(2.1.8), (2.1.9)";

const ComparedQuantity quantities[] = {
    {"contact_radius", "a", "(3 F_N R/(4 E*))^(1/3), 1/E* = sum (1 - nu_i^2)/E_i", hertz_source,
     "m", [](const RigData& r) { return hertz_of(r).contact_radius; },
     [](const RigData& r) { return layer_of(r).contact_radius; }},
    {"indentation", "d", "a^2/R", hertz_source, "m",
     [](const RigData& r) { return hertz_of(r).indentation; },
     [](const RigData& r) { return layer_of(r).indentation; }},
    {"peak_pressure", "p_0", "3 F_N/(2 pi a^2)", hertz_source, "Pa",
     [](const RigData& r) { return hertz_of(r).peak_pressure; },
     [](const RigData& r) { return layer_of(r).centre_pressure; }},
    {"unit_shift", "U_max", "mu d E*/G* at mu = 1", hertz_source, "m",
     [](const RigData& r) { return hertz_of(r).unit_shift; },
     [](const RigData& r) { return *layer_of(r).unit_shift; }},
    {"normal_stiffness", "k_N", "2 E* a", hertz_source, "N/m",
     [](const RigData& r) {
         return 2 * materials_of(r).effective_modulus() * hertz_of(r).contact_radius;
     },
     [](const RigData& r) { return layer_of(r).normal_stiffness; }},
};

Formula thickness_formula(const Rig& rig) {
    return {"thickness_ratio",
            "b/D_c",
            rig.D_c.is_known() ? "b/D_c, D_c as measured" : "b/D_c, D_c = 2 a of Hertz",
            "(5.1.13)",
            "1",
            {&Rig::b, &Rig::D_c},
            [](const RigData& r) { return r.b / r.D_c; }};
}

/// E* by Hertz' formulas from what the layer shows, over the true one.
constexpr Formula modulus_factors[] = {
    Formula("modulus_from_indentation", "E_Hertz/E", "3 F_N/(4 sqrt(R) d^(3/2) E'), d of the layer",
            "Johnson (1985), ch. 4", "1", layer_inputs,
            [](const RigData& r) {
                return theory::hertz_modulus_from_indentation(r.F_N, r.R, layer_of(r).indentation) *
                       (1 - r.nu_2 * r.nu_2) / r.E_2;
            }),
    Formula("modulus_from_contact_radius", "E_Hertz/E", "3 F_N R/(4 a^3 E'), a of the layer",
            "Johnson (1985), ch. 4", "1", layer_inputs, [](const RigData& r) {
                return theory::hertz_modulus_from_contact_radius(r.F_N, r.R,
                                                                 layer_of(r).contact_radius) *
                       (1 - r.nu_2 * r.nu_2) / r.E_2;
            })};

/// Both diameters [m] beside the measured one.
std::string measured_sentence(const Rig& rig) {
    const double hertz = 2 * half_size(rig), layer = hertz * quantities[0].ratio(rig);
    const double size = rig.D_c, error = rig.D_c.standard_error;
    if (error == 0)
        return fmt::format(
            "The measured diameter of {}, whose error is not given, stands beside {} on the layer "
            "and {} by Hertz.",
            quantity(size, "m", 3), quantity(layer, "m", 3), quantity(hertz, "m", 3));
    const bool fits_hertz = std::abs(size - hertz) <= error;
    const bool fits_layer = std::abs(size - layer) <= error;
    const char* verdict = fits_hertz && fits_layer ? "does not distinguish the two"
                          : fits_layer             ? "fits the layer, not Hertz"
                          : fits_hertz             ? "fits Hertz, not the layer"
                                                   : "fits neither";
    const auto unit = contact::fitting_prefix(size);
    return fmt::format("The measured diameter of {} {}m {}: {} on the layer, {} by Hertz.",
                       with_error(size / unit.factor, error / unit.factor), unit.symbol, verdict,
                       quantity(layer, "m", 3), quantity(hertz, "m", 3));
}

std::string layer_sentences(const Rig& rig) {
    const auto beside = [&](std::size_t i) { return beside_hertz(quantities[i].ratio(rig)); };
    const std::string measured = rig.D_c.is_known() ? ' ' + measured_sentence(rig) : "";
    return fmt::format(
        "Indentation is {}: E from force and indentation would be {} times the true one. The "
        "stiffness is {} times Hertz', the peak pressure {}, the unit of shift {}. The contact "
        "radius is {}.{}",
        beside(1), significant(calculate(rig, modulus_factors[0]).result.value, 3),
        significant(quantities[4].ratio(rig), 3), beside(2), beside(3), beside(0), measured);
}

}  // namespace

Assumption half_space_assumption(const Rig& rig, Calculation thickness_ratio,
                                 std::span<const ComparedQuantity> compared,
                                 const LayerTheory& theory) {
    using enum Criterion::Relation;
    Assumption a{
        .name = "half_space",
        .title = "Half-space",
        .claim = is_thesis_rig(rig) ? "The substrate is a half-space, since b >= D_c suffices"
                                    : "The substrate is a half-space",
        .criteria = {{std::move(thickness_ratio), at_least, 1,
                      "the rule of Wetter (2016), section 5.1.5: necessary, not sufficient"}}};
    const bool rigid = roller_is_rigid(rig);
    if (!rigid) a.missing = {theory_of_elastic_roller};
    a.consequence = rigid ? theory.consequence(rig)
                          : "The roller is not rigid beside the substrate, as the layer's theory "
                            "takes it: the two contacts are not compared.";
    for (const ComparedQuantity& q : compared) {
        a.background.push_back(calculate(rig, q.name, q.symbol, q.formula, q.source, q.unit,
                                         hertz_inputs, q.half_space));
        if (!rigid) continue;
        a.criteria.push_back(
            {calculate(rig, std::string(q.name) + "_difference",
                       fmt::format("|{0} layer/{0} Hertz - 1|", q.symbol),
                       "the layer's over the half-space's, from the same data", theory.source, "1",
                       hertz_inputs + Inputs{&Rig::b},
                       [&q](const RigData& r) { return std::abs(q.ratio(r) - 1); }),
             at_most, accepted_difference, accepted_reason});
        a.background.push_back(calculate(rig, std::string("layer_") + q.name,
                                         std::string(q.symbol) + ", layer", theory.formula,
                                         theory.source, q.unit, layer_inputs, q.layer));
    }
    return a;
}

Assumption half_space(const Rig& rig) {
    Assumption a = half_space_assumption(rig, calculate(rig, thickness_formula(rig)), quantities,
                                         {"Fredholm equation", exact_layer, layer_sentences});
    if (roller_is_rigid(rig))
        for (const Formula& factor : modulus_factors)
            a.background.push_back(calculate(rig, factor));
    return a;
}

}  // namespace tricontact::experiments
